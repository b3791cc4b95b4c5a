# find_package(tpg_runtime CONFIG REQUIRED) gives the target tpg_runtime::tpg_runtime.
#
# One folder holds the library for several targets. Which one: TPG_RUNTIME_TARGET, a Rust triple; without it, what the
# processor of a cross build suggests, or the compiler's flags where that is just "arm" or "riscv"; this machine's otherwise.
# A Cortex-M4 and more without -mfloat-abi in CMAKE_C_FLAGS is taken for one with hardware floats in its calls.

get_filename_component(_tpg_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

if(NOT DEFINED TPG_RUNTIME_TARGET)
  string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" _tpg_cpu)
  set(_tpg_flags "${CMAKE_C_FLAGS_INIT} ${CMAKE_C_FLAGS}")
  # The last word counts, as for the compiler.
  if(_tpg_flags MATCHES ".*-mcpu=([^ ;]+)")
    set(_tpg_cpu "${CMAKE_MATCH_1}")
  elseif(_tpg_flags MATCHES ".*-march=(rv32[^ ;]*)")
    set(_tpg_cpu "${CMAKE_MATCH_1}")
  elseif(_tpg_cpu STREQUAL "arm" AND PICO_PLATFORM MATCHES "^rp2040")
    set(_tpg_cpu cortex-m0plus)
  elseif(_tpg_cpu STREQUAL "arm" AND PICO_PLATFORM MATCHES "^rp2350")
    set(_tpg_cpu cortex-m33)
    # As its compiler is called: floats are passed in integer registers.
    set(_tpg_flags "-mfloat-abi=softfp ${_tpg_flags}")
  endif()
  set(_tpg_abi eabihf)
  if(_tpg_flags MATCHES ".*-mfloat-abi=([a-z]+)" AND NOT CMAKE_MATCH_1 STREQUAL "hard")
    set(_tpg_abi eabi)
  endif()

  if(_tpg_cpu MATCHES "^cortex-m(0|0plus|1)$")
    set(TPG_RUNTIME_TARGET thumbv6m-none-eabi)
  elseif(_tpg_cpu MATCHES "^cortex-m3$")
    set(TPG_RUNTIME_TARGET thumbv7m-none-eabi)
  elseif(_tpg_cpu MATCHES "^cortex-m(4|7)")
    set(TPG_RUNTIME_TARGET thumbv7em-none-${_tpg_abi})
  elseif(_tpg_cpu MATCHES "^cortex-m23$")
    set(TPG_RUNTIME_TARGET thumbv8m.base-none-eabi)
  elseif(_tpg_cpu MATCHES "^cortex-m(33|35p|52|55|85)")
    set(TPG_RUNTIME_TARGET thumbv8m.main-none-${_tpg_abi})
  elseif(_tpg_cpu MATCHES "^rv32(imaf|g)" AND NOT _tpg_flags MATCHES "-mabi=ilp32( |;|$)")
    set(TPG_RUNTIME_TARGET riscv32imafc-unknown-none-elf)
  elseif(_tpg_cpu MATCHES "^rv32(ima|g)")
    set(TPG_RUNTIME_TARGET riscv32imac-unknown-none-elf)
  elseif(_tpg_cpu MATCHES "^rv32im")
    set(TPG_RUNTIME_TARGET riscv32imc-unknown-none-elf)
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
