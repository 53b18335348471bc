# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The ParaView plugin VolumeOptics, in <prefix>/lib/paraview-5.11/plugins/VolumeOptics: the module's library,
# that of the representation, and the plugin itself.

# Components, because without them all are looked for, and with them Qt.
find_package(ParaView 5.11 REQUIRED COMPONENTS
  icet RemotingCore RemotingServerManager RemotingViews VTKExtensionsCore)

paraview_plugin_scan(
  PLUGIN_FILES      "${CMAKE_CURRENT_SOURCE_DIR}/Module/ParaView/paraview.plugin"
  PROVIDES_PLUGINS  plugins
  ENABLE_BY_DEFAULT ON)

set(volumeoptics_paraview_dir "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/VolumeOptics")
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../../..")

vtk_module_scan(
  MODULE_FILES
    "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module"
    "${CMAKE_CURRENT_SOURCE_DIR}/Module/ParaView/Classes/vtk.module"
  REQUEST_MODULES  VolumeOptics::VolumeOptics VolumeOptics::ParaView
  PROVIDES_MODULES modules
  ENABLE_TESTS     OFF)

# A module's target is the last part of its name, which the plugin's target takes.
set_property(GLOBAL PROPERTY "_vtk_module_VolumeOptics::VolumeOptics_target_name" vtkVolumeOptics)

# See Module/Standalone.cmake.
get_filename_component(volumeoptics_parent "${CMAKE_CURRENT_SOURCE_DIR}" DIRECTORY)
set(volumeoptics_source_dir "${CMAKE_SOURCE_DIR}")
set(volumeoptics_library_dir "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CMAKE_SOURCE_DIR "${volumeoptics_parent}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${volumeoptics_paraview_dir}")
vtk_module_build(
  MODULES             ${modules}
  PACKAGE             VolumeOpticsParaView
  INSTALL_HEADERS     OFF
  LIBRARY_DESTINATION "${volumeoptics_paraview_dir}"
  TARGETS_COMPONENT   paraview_plugins)
set(CMAKE_SOURCE_DIR "${volumeoptics_source_dir}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${volumeoptics_library_dir}")

# The documentation would take Qt's help generator.
paraview_plugin_build(
  RUNTIME_DESTINATION  "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME    "volumeoptics.plugins.xml"
  PLUGINS_COMPONENT    paraview_plugins
  TARGET_COMPONENT     paraview_plugins
  INSTALL_HEADERS      OFF
  ADD_INSTALL_RPATHS   OFF
  DISABLE_XML_DOCUMENTATION ON
  PLUGINS              ${plugins}
  AUTOLOAD             ${plugins})

include(Module/DebianPackage.cmake)

if (BUILD_TESTING)
  add_subdirectory(Testing/ParaView)
endif ()
