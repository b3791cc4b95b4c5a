@PACKAGE_INIT@
include("${CMAKE_CURRENT_LIST_DIR}/{{ it.name }}-targets.cmake")
