/*
{%- for line in banner %}
 * {{ line }}
{%- endfor %}
 */
#include "{{ prefix }}.h"

const uint32_t {{ prefix }}[{{ upper }}_WORDS] = {
{%- for line in lines %}
    {{ line }},
{%- endfor %}
};
