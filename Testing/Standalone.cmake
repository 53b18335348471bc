# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Tests of the whole project; those of the module's classes are in Testing/Cxx.

set(volumeoptics_python_environment
  "PYTHONPATH=${CMAKE_BINARY_DIR}/lib/python3/dist-packages")
set(volumeoptics_test_flags "${CMAKE_CXX_FLAGS}")
set(volumeoptics_preload)
if (VOLUMEOPTICS_SANITIZE)
  string(APPEND volumeoptics_test_flags " -fsanitize=${VOLUMEOPTICS_SANITIZE}")
endif ()
# A Python that is not sanitized itself loads the address sanitizer first, and its own leaks do not
# count. That of undefined behaviour may come later, with the module.
if (VOLUMEOPTICS_SANITIZE MATCHES "address")
  foreach (library IN ITEMS libasan.so libstdc++.so)
    execute_process(COMMAND "${CMAKE_CXX_COMPILER}" "-print-file-name=${library}"
      OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE)
    list(APPEND volumeoptics_preload "${path}")
  endforeach ()
  list(JOIN volumeoptics_preload ":" volumeoptics_preload)
  list(APPEND volumeoptics_python_environment
    "LD_PRELOAD=${volumeoptics_preload}" "ASAN_OPTIONS=detect_leaks=0")
endif ()

add_subdirectory(Testing/Plugin)
set(volumeoptics_python "")
if (TARGET VolumeOptics::Python)
  add_subdirectory(Testing/Python)
  set(volumeoptics_python "${Python3_EXECUTABLE}")
endif ()

# The install tree, and the package where Debian's tools are there.
find_program(VOLUMEOPTICS_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(VOLUMEOPTICS_SHLIBDEPS)
set(volumeoptics_install_tests Install)
if (VOLUMEOPTICS_SHLIBDEPS AND NOT VOLUMEOPTICS_SANITIZE)
  list(APPEND volumeoptics_install_tests Package)
endif ()
foreach (name IN LISTS volumeoptics_install_tests)
  set(volumeoptics_package OFF)
  if (name STREQUAL "Package")
    set(volumeoptics_package ON)
  endif ()
  add_test(NAME "VolumeOptics${name}"
    COMMAND "${CMAKE_COMMAND}"
      -D "build=${CMAKE_BINARY_DIR}"
      -D "package=${volumeoptics_package}"
      -D "source=${CMAKE_CURRENT_SOURCE_DIR}/Testing/Downstream"
      -D "work=${CMAKE_BINARY_DIR}/Testing/Temporary/${name}"
      -D "generator=${CMAKE_GENERATOR}"
      -D "flags=${volumeoptics_test_flags}"
      -D "python=${volumeoptics_python}"
      -D "preload=${volumeoptics_preload}"
      -D "program=$<TARGET_FILE:VTKProgram>"
      -P "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Downstream/Install.cmake")
  # Both write the build tree's list of installed files.
  set_tests_properties("VolumeOptics${name}" PROPERTIES LABELS unit RESOURCE_LOCK install)
endforeach ()

add_subdirectory(Testing/Distributed)
add_subdirectory(Testing/Benchmark)
