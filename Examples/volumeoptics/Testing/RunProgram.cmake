cmake_minimum_required(VERSION 3.18)
# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs ${program} ${arguments}; checks exit code, output and, if the arguments name it, the picture.

set(least_picture_bytes 1500) # a blank one of 128 x 128 has about 400

file(REMOVE "${picture}")
execute_process(
  COMMAND         "${program}" ${arguments}
  RESULT_VARIABLE result
  OUTPUT_VARIABLE output
  ERROR_VARIABLE  output)
message("${output}")
if (NOT result STREQUAL code)
  message(FATAL_ERROR "exit code ${result} instead of ${code}")
endif ()
if (NOT output MATCHES "${pattern}")
  message(FATAL_ERROR "the output does not match '${pattern}'")
endif ()
if (output MATCHES "ERR\\||WARN\\||Warning:")
  message(FATAL_ERROR "VTK complains")
endif ()
if ("${picture}" IN_LIST arguments)
  file(SIZE "${picture}" bytes)
  if (bytes LESS least_picture_bytes)
    message(FATAL_ERROR "${picture} has ${bytes} bytes: it is blank")
  endif ()
endif ()
