# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The package volumeoptics, in <prefix>/lib/python3/dist-packages.
set(volumeoptics_python_dir "lib/python3/dist-packages")

vtk_module_wrap_python(
  MODULES             ${modules}
  TARGET              VolumeOptics::Python
  INSTALL_EXPORT      VolumeOptics
  PYTHON_PACKAGE      volumeoptics
  MODULE_DESTINATION  "${volumeoptics_python_dir}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION   "${volumeoptics_cmake_dir}"
  BUILD_STATIC        OFF)

configure_file(Module/Python/__init__.py
  "${CMAKE_BINARY_DIR}/${volumeoptics_python_dir}/volumeoptics/__init__.py" COPYONLY)
install(FILES Module/Python/__init__.py
  DESTINATION "${volumeoptics_python_dir}/volumeoptics")
