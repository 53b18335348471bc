# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# find_package(VolumeOptics), from the install tree wherever it is moved to.
include(CMakePackageConfigHelpers)
set(volumeoptics_plugin_path "${CMAKE_INSTALL_LIBDIR}/volumeoptics/plugin")
set(volumeoptics_python_path "lib/python3/dist-packages")
set(config "${CMAKE_BINARY_DIR}/${volumeoptics_cmake_dir}/VolumeOpticsConfig.cmake")
set(config_version "${CMAKE_BINARY_DIR}/${volumeoptics_cmake_dir}/VolumeOpticsConfigVersion.cmake")
configure_package_config_file(Module/VolumeOpticsConfig.cmake.in "${config}"
  INSTALL_DESTINATION "${volumeoptics_cmake_dir}"
  PATH_VARS           volumeoptics_plugin_path volumeoptics_python_path)
write_basic_package_version_file("${config_version}"
  VERSION       "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
install(FILES "${config}" "${config_version}" DESTINATION "${volumeoptics_cmake_dir}")
