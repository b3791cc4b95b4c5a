cmake_minimum_required(VERSION 3.16)
project({{ it.name }} VERSION {{ it.details.version }} LANGUAGES C)

option({{ it.upper }}_EXAMPLES "Build the example" OFF)

add_library({{ it.name }} STATIC src/{{ it.name }}.c)
add_library({{ it.name }}::{{ it.name }} ALIAS {{ it.name }})
target_include_directories({{ it.name }} PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:include>)
{%- if it.libm %}
target_link_libraries({{ it.name }} PUBLIC m)
{%- endif %}

if({{ it.upper }}_EXAMPLES)
  add_executable({{ it.name }}_decide examples/decide.c)
  target_link_libraries({{ it.name }}_decide PRIVATE {{ it.name }})
endif()

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(_{{ it.name }}_cmake ${CMAKE_INSTALL_LIBDIR}/cmake/{{ it.name }})
install(TARGETS {{ it.name }} EXPORT {{ it.name }}-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES include/{{ it.name }}.h DESTINATION include)
install(EXPORT {{ it.name }}-targets NAMESPACE {{ it.name }}:: DESTINATION ${_{{ it.name }}_cmake})
configure_package_config_file(cmake/{{ it.name }}-config.cmake.in {{ it.name }}-config.cmake
  INSTALL_DESTINATION ${_{{ it.name }}_cmake})
write_basic_package_version_file({{ it.name }}-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/{{ it.name }}-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/{{ it.name }}-config-version.cmake
  DESTINATION ${_{{ it.name }}_cmake})
