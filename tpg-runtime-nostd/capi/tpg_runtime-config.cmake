# find_package(tpg_runtime CONFIG REQUIRED) gives the target tpg_runtime::tpg_runtime.
#
# One folder holds the library for several targets. Which one: TPG_RUNTIME_TARGET, a Rust triple; without it, what the
# processor of a cross build suggests (hard-float ABI on a Cortex-M4 or -M7), and this machine's otherwise.

get_filename_component(_tpg_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

if(NOT DEFINED TPG_RUNTIME_TARGET)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^[Cc]ortex-[Mm](4|7)")
    set(TPG_RUNTIME_TARGET thumbv7em-none-eabihf)
  elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^[Cc]ortex-[Mm](0|0plus|1)$")
    set(TPG_RUNTIME_TARGET thumbv6m-none-eabi)
  elseif(NOT CMAKE_CROSSCOMPILING AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set(TPG_RUNTIME_TARGET ${CMAKE_SYSTEM_PROCESSOR}-unknown-linux-gnu)
  endif()
endif()

set(_tpg_library "${_tpg_prefix}/lib/${TPG_RUNTIME_TARGET}/libtpg_runtime.a")
if(EXISTS "${_tpg_library}")
  if(NOT TARGET tpg_runtime::tpg_runtime)
    add_library(tpg_runtime::tpg_runtime STATIC IMPORTED)
    set_target_properties(tpg_runtime::tpg_runtime PROPERTIES
      IMPORTED_LOCATION "${_tpg_library}"
      INTERFACE_INCLUDE_DIRECTORIES "${_tpg_prefix}/include")
  endif()
else()
  file(GLOB _tpg_found RELATIVE "${_tpg_prefix}/lib" "${_tpg_prefix}/lib/*/libtpg_runtime.a")
  set(tpg_runtime_FOUND FALSE)
  set(tpg_runtime_NOT_FOUND_MESSAGE
    "no ${_tpg_library}; set TPG_RUNTIME_TARGET to a triple that is there: ${_tpg_found}")
endif()
