idf_component_register(SRCS "{{ it.name }}.c" INCLUDE_DIRS "include")
