# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# `cpack -G DEB` in the build tree gives one Debian package, `cpack -G TGZ` the install tree as an archive.
# Configured with -D CMAKE_INSTALL_PREFIX=/usr (the preset "package"), libraries lie in Debian's
# multiarch folder. The ParaView component, where it is built, is a package of its own.
set(CPACK_PACKAGE_NAME volumeoptics)
set(CPACK_PACKAGE_VENDOR "VolumeOptics contributors")
set(CPACK_PACKAGE_CONTACT "VolumeOptics contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "optical models for VTK's volume rendering")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "\
A VTK module: a volume mapper with anisotropic highlights, scale-invariant
opacity, lighting transfer functions and voxels of lines, the filters that
prepare a volume, and a render window that needs no display.
.
The package has the library, the Python package volumeoptics, the plugin for
existing VTK programs, the program volumeoptics, and what is needed to build
other programs on them.")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# What is loaded at run time, or used by programs built on the package.
if (TARGET VolumeOptics::Python)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-vtk9")
endif ()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libosmesa6, libvtk9-dev")

# CPack's own shlibs would name the plugin, too, which nothing links.
file(WRITE "${CMAKE_BINARY_DIR}/debian/shlibs"
  "libvtkVolumeOptics 1 volumeoptics (>= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_BINARY_DIR}/debian/shlibs")

configure_file(LICENSE "${CMAKE_BINARY_DIR}/debian/copyright" COPYONLY)
install(FILES "${CMAKE_BINARY_DIR}/debian/copyright" CHANGELOG.md README.md
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/volumeoptics")
include(CPack)
