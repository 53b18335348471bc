# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Shader text is ASCII, opens with the two SPDX lines and holds no //VTK:: tag, which VTK would replace
# even in a comment, but those that a whole shader begins with; in Module/Optics, nothing that is not C++, too.
#   cmake -DSOURCE_FOLDER=... -P CheckShaderText.cmake

set(head "// SPDX-FileCopyrightText: VolumeOptics contributors\n// SPDX-License-Identifier: BSD-3-Clause\n")
string(LENGTH "${head}" head_length)
set(failures 0)

macro (fail message)
  message(STATUS "${shader}: ${message}")
  math(EXPR failures "${failures} + 1")
endmacro ()

file(GLOB optics "${SOURCE_FOLDER}/Module/Optics/*.glsl")
file(GLOB rendering "${SOURCE_FOLDER}/Rendering/glsl/*.glsl")
if (NOT optics)
  message(FATAL_ERROR "no shader in ${SOURCE_FOLDER}/Module/Optics")
endif ()

foreach (shader IN LISTS optics rendering)
  file(READ "${shader}" bytes HEX)
  string(REGEX MATCHALL ".." bytes "${bytes}")
  list(FILTER bytes EXCLUDE REGEX "^(0a|[2-6][0-9a-f]|7[0-9a-e])$")
  if (bytes)
    list(GET bytes 0 byte)
    fail("byte 0x${byte}: only printable ASCII and line feeds, no tab")
  endif ()

  file(READ "${shader}" text)
  string(SUBSTRING "${text}" 0 ${head_length} first)
  if (NOT first STREQUAL head)
    fail("does not open with the two SPDX lines")
  endif ()
  string(REGEX REPLACE "^([^\n]*\n[^\n]*\n\n)(//VTK::System::Dec\n)?(//VTK::Output::Dec\n)?" "\\1" text "${text}")
  if (shader MATCHES "/SweepRayEnd.glsl$") # a sweep crops as VTK's own text does
    string(REPLACE "  //VTK::Cropping::Init\n" "" text "${text}")
  endif ()
  if (text MATCHES "//VTK::[A-Za-z:]*")
    fail("holds the tag ${CMAKE_MATCH_0}")
  endif ()
endforeach ()

foreach (shader IN LISTS optics)
  file(READ "${shader}" text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  if (text MATCHES "#[a-z]+|(^|[^A-Za-z_])(uniform|sampler[123]D|inout|out|in)[ \n]")
    string(STRIP "${CMAKE_MATCH_0}" word)
    fail("holds ${word}: no preprocessor, uniform, sampler or out parameter")
  endif ()
  if (text MATCHES "\\.[xyzwrgbastpq][xyzwrgbastpq]+[^A-Za-z0-9_(]")
    string(STRIP "${CMAKE_MATCH_0}" swizzle)
    fail("holds ${swizzle}: no swizzle of several letters")
  endif ()
  if (text MATCHES "[0-9]\\.[^0-9]|[^0-9]\\.[0-9]|[0-9]f[^A-Za-z0-9]")
    fail("holds ${CMAKE_MATCH_0}: literals have digits on both sides of the point and no suffix")
  endif ()
endforeach ()

if (failures)
  message(FATAL_ERROR "${failures} faults in shader text")
endif ()
