# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The window without a display: with either driver, with the second one where
# the first one fails, and with none. The argument is what it must draw with.
set(TestHeadlessRenderWindow_ARGS EGL)
set(TestHeadlessRenderWindowOSMesa_ARGS OSMesa)
set(TestHeadlessRenderWindowFallback_ARGS OSMesa)
volumeoptics_add_tests(unit NO_VALID NO_OUTPUT
  TestHeadlessRenderWindow.cxx
  TestHeadlessRenderWindowOSMesa,TestHeadlessRenderWindow.cxx
  TestHeadlessRenderWindowFallback,TestHeadlessRenderWindow.cxx
  TestHeadlessWithoutDriver.cxx)

set(unusable "${CMAKE_CURRENT_BINARY_DIR}/UnusableLibraries")
file(WRITE "${unusable}/libEGL.so.1" "")
file(WRITE "${unusable}/libOSMesa.so.8" "")
set_tests_properties("${prefix}TestHeadlessRenderWindow" PROPERTIES
  ENVIRONMENT "VOLUMEOPTICS_HEADLESS=egl")
set_tests_properties("${prefix}TestHeadlessRenderWindowOSMesa" PROPERTIES
  ENVIRONMENT "VOLUMEOPTICS_HEADLESS=osmesa")
set_tests_properties("${prefix}TestHeadlessRenderWindowFallback" PROPERTIES
  ENVIRONMENT "VOLUMEOPTICS_HEADLESS=1;__EGL_VENDOR_LIBRARY_FILENAMES=${unusable}/none.json")
set_tests_properties("${prefix}TestHeadlessWithoutDriver" PROPERTIES
  ENVIRONMENT "VOLUMEOPTICS_HEADLESS=1;LD_LIBRARY_PATH=${unusable}")
