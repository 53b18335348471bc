# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The project around the module: finds VTK, builds, wraps, tests and installs it.

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release or RelWithDebInfo" FORCE)
endif ()
option(BUILD_SHARED_LIBS "Build shared libraries" ON)
option(VOLUMEOPTICS_WRAP_PYTHON "Build the Python package volumeoptics" ON)
option(VOLUMEOPTICS_BUILD_PARAVIEW_PLUGIN
  "Build the plugin for ParaView, and nothing else, against ParaView's own VTK" OFF)

set(VOLUMEOPTICS_SANITIZE "" CACHE STRING
  "Sanitizers to build with, as in -fsanitize=; the presets asan, ubsan and tsan set it")
if (VOLUMEOPTICS_SANITIZE)
  add_compile_options("-fsanitize=${VOLUMEOPTICS_SANITIZE}" -fno-omit-frame-pointer)
  add_link_options("-fsanitize=${VOLUMEOPTICS_SANITIZE}")
endif ()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

include(GNUInstallDirs)
include(CTest)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

set(volumeoptics_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/VolumeOptics")

find_package(glm REQUIRED)

# ParaView brings a VTK of its own: one build tree has one VTK.
if (VOLUMEOPTICS_BUILD_PARAVIEW_PLUGIN)
  include(Module/ParaView/Plugin.cmake)
  return()
endif ()

# Debian's VTK belongs to Debian's Python, which need not be the first one on PATH.
if (NOT DEFINED Python3_EXECUTABLE AND NOT VTK_DIR)
  execute_process(COMMAND /usr/bin/python3 -c "import vtkmodules"
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if (result EQUAL 0)
    set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that VTK is wrapped for")
  endif ()
endif ()

set(volumeoptics_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  FiltersSources IOImage ImagingCore ImagingGeneral ImagingMath InteractionStyle
  ParallelCore RenderingContext2D RenderingContextOpenGL2 RenderingCore RenderingFreeType
  RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2 TestingCore TestingRendering
  ViewsContext2D jsoncpp opengl)
find_package(VTK 9.1 REQUIRED COMPONENTS ${volumeoptics_vtk_components}
  OPTIONAL_COMPONENTS WrappingPythonCore Python glew glad)

vtk_module_scan(
  MODULE_FILES     "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module"
  REQUEST_MODULES  VolumeOptics::VolumeOptics
  PROVIDES_MODULES modules
  ENABLE_TESTS     "${BUILD_TESTING}")

# Before the module, because the module's tests link it.
add_subdirectory(Testing/Reference)

# vtk_module_build() adds the module's folder by its path relative to
# CMAKE_SOURCE_DIR, which is empty for a vtk.module at the top: pretend that the
# project is one level up.
get_filename_component(volumeoptics_parent "${CMAKE_CURRENT_SOURCE_DIR}" DIRECTORY)
set(volumeoptics_source_dir "${CMAKE_SOURCE_DIR}")
set(CMAKE_SOURCE_DIR "${volumeoptics_parent}")
vtk_module_build(
  MODULES             ${modules}
  PACKAGE             VolumeOptics
  INSTALL_EXPORT      VolumeOptics
  VERSION             "${PROJECT_VERSION}"
  SOVERSION           1
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/VolumeOptics"
  CMAKE_DESTINATION   "${volumeoptics_cmake_dir}")
set(CMAKE_SOURCE_DIR "${volumeoptics_source_dir}")

if (VOLUMEOPTICS_WRAP_PYTHON AND TARGET VTK::WrappingPythonCore)
  include(Module/Python.cmake)
endif ()
add_subdirectory(Module/Plugin)
include(Module/Package.cmake)
add_subdirectory(Examples)
include(Module/DebianPackage.cmake)

if (BUILD_TESTING)
  include(Testing/Standalone.cmake)
endif ()
