# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# What the tests of Module/Optics need of the test executable: the formulas, and copies of them whose
# literals are floats in C++.

get_filename_component(optics_folder "${CMAKE_CURRENT_LIST_DIR}/../../Module/Optics" ABSOLUTE)
file(GLOB optics_shaders CONFIGURE_DEPENDS "${optics_folder}/*.glsl")
foreach (shader IN LISTS optics_shaders ITEMS "${CMAKE_CURRENT_LIST_DIR}/OpticsTable.glsl")
  file(READ "${shader}" text)
  string(REGEX REPLACE "([0-9]+\\.[0-9]+(e[-+]?[0-9]+)?)" "\\1f" text "${text}")
  get_filename_component(name "${shader}" NAME)
  file(GENERATE
    OUTPUT  "${CMAKE_CURRENT_BINARY_DIR}/OpticsFloat/${name}"
    CONTENT "${text}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${shader}")
endforeach ()

target_include_directories(vtkVolumeOpticsCxxTests PRIVATE
  "${optics_folder}" "${CMAKE_CURRENT_BINARY_DIR}")
target_compile_definitions(vtkVolumeOpticsCxxTests PRIVATE
  "VOLUMEOPTICS_OPTICS_FOLDER=\"${optics_folder}\""
  "VOLUMEOPTICS_TESTS_FOLDER=\"${CMAKE_CURRENT_LIST_DIR}\"")

# The rules that no compiler knows.
add_test(NAME "VolumeOptics::ShaderText"
  COMMAND "${CMAKE_COMMAND}" "-DSOURCE_FOLDER=${optics_folder}/../.."
    -P "${CMAKE_CURRENT_LIST_DIR}/CheckShaderText.cmake")
set_property(TEST "VolumeOptics::ShaderText" PROPERTY LABELS unit)
