# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs the build tree, moves the install tree, and uses it there: from CMake projects, by the
# program, from Python, and as a plugin. With -D package=ON the tree is that of the Debian package,
# unpacked. Run by CTest as
#   cmake -D build=... -D source=... -D work=... (Testing/Standalone.cmake) -P Install.cmake

function (run)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "This failed (${result}): ${command}\n${output}")
  endif ()
endfunction ()

# The package names what it needs, and its tree is <work>/package/usr.
function (unpack_package)
  run(cpack --config "${build}/CPackConfig.cmake" -G DEB -B "${work}")
  file(GLOB packages "${work}/*.deb")
  foreach (field IN ITEMS "Package: volumeoptics" "Section: science" "Depends: .*libvtk9"
      "Description: optical models" "Maintainer: VolumeOptics")
    execute_process(COMMAND dpkg-deb --field ${packages} OUTPUT_VARIABLE fields)
    if (NOT "\n${fields}" MATCHES "\n${field}")
      message(FATAL_ERROR "The package has no field ${field}:\n${fields}")
    endif ()
  endforeach ()
  run(dpkg-deb --extract ${packages} "${work}/package")
  if (NOT EXISTS "${work}/package/usr/share/doc/volumeoptics/copyright")
    message(FATAL_ERROR "The package has no licence.")
  endif ()
endfunction ()

set(prefix "${work}/moved prefix")
file(REMOVE_RECURSE "${work}")
file(MAKE_DIRECTORY "${work}")
if (package)
  unpack_package()
  file(RENAME "${work}/package/usr" "${prefix}")
else ()
  run("${CMAKE_COMMAND}" --install "${build}" --prefix "${work}/prefix")
  file(RENAME "${work}/prefix" "${prefix}")
endif ()

run("${CMAKE_COMMAND}" -S "${source}" -B "${work}/build" -G "${generator}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_BUILD_TYPE=Release" "-DCMAKE_CXX_FLAGS=${flags}")
run("${CMAKE_COMMAND}" --build "${work}/build")
run("${work}/build/downstream")
run("${CMAKE_COMMAND}" -E chdir "${work}" "${work}/build/example/render_ellipsoid")
if (NOT EXISTS "${work}/ellipsoid.png")
  message(FATAL_ERROR "The example in Examples/cxx wrote no picture.")
endif ()

# The program is left out where its libraries are not there.
if (EXISTS "${prefix}/bin/volumeoptics")
  run("${prefix}/bin/volumeoptics" --version)
endif ()

include("${work}/build/paths.cmake")
set(ENV{VOLUMEOPTICS_HEADLESS} 1)
if (python)
  set(sanitizer)
  if (preload)
    set(sanitizer "LD_PRELOAD=${preload}" "ASAN_OPTIONS=detect_leaks=0")
  endif ()
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${python_dir}" ${sanitizer}
    "${python}" "${source}/downstream.py" "${prefix}")
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${python_dir}" ${sanitizer}
    "${python}" "${source}/../../Examples/python/render_ellipsoid.py" "${work}/python.png")
  if (NOT EXISTS "${work}/python.png")
    message(FATAL_ERROR "The example in Examples/python wrote no picture.")
  endif ()
endif ()
run("${CMAKE_COMMAND}" -E env "VTK_AUTOLOAD_PATH=${plugin_dir}"
  "${program}" vtkOpticsVolumeMapper render)
