# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The plugin without a preset leaves a program's picture as it was; a preset changes it.
#   cmake -D program=... -D plugin=... -D preset=... -P Preset.cmake

function (picture result mapper)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env ${ARGN} "${program}" "${mapper}" render
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if (NOT status EQUAL 0 OR error)
    message(FATAL_ERROR "The program failed (${status}) with ${ARGN}:\n${output}${error}")
  endif ()
  string(REGEX MATCHALL "picture: [0-9 ]+" pictures "${output}")
  set("${result}" "${pictures}" PARENT_SCOPE)
endfunction ()

set(ENV{VOLUMEOPTICS_HEADLESS} 1)
picture(plain vtkOpticsVolumeMapper "VTK_AUTOLOAD_PATH=${plugin}")
picture(ward vtkOpticsVolumeMapper "VTK_AUTOLOAD_PATH=${plugin}" "VOLUMEOPTICS_PRESET=${preset}")
if (plain STREQUAL ward)
  message(FATAL_ERROR "The preset does not change the picture: ${plain}")
endif ()

# Without the plugin the program needs a display.
if (DEFINED ENV{DISPLAY})
  unset(ENV{VOLUMEOPTICS_HEADLESS})
  picture(stock vtkOpenGLGPUVolumeRayCastMapper --unset=VTK_AUTOLOAD_PATH)
  if (NOT plain STREQUAL stock)
    message(FATAL_ERROR "The plugin changes the picture from ${stock} to ${plain}")
  endif ()
endif ()
