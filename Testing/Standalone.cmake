# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Tests of the whole project; those of the module's classes are in Testing/Cxx.

add_subdirectory(Testing/Plugin)
set(volumeoptics_python "")
if (TARGET VolumeOptics::Python)
  add_subdirectory(Testing/Python)
  set(volumeoptics_python "${Python3_EXECUTABLE}")
endif ()

add_test(NAME VolumeOpticsInstall
  COMMAND "${CMAKE_COMMAND}"
    -D "build=${CMAKE_BINARY_DIR}"
    -D "source=${CMAKE_CURRENT_SOURCE_DIR}/Testing/Downstream"
    -D "work=${CMAKE_BINARY_DIR}/Testing/Temporary/Downstream"
    -D "generator=${CMAKE_GENERATOR}"
    -D "flags=${CMAKE_CXX_FLAGS}"
    -D "python=${volumeoptics_python}"
    -D "program=$<TARGET_FILE:VTKProgram>"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Downstream/Install.cmake")
set_tests_properties(VolumeOpticsInstall PROPERTIES LABELS unit)
