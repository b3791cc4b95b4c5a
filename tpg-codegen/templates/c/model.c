/*
{%- for line in banner %}
 * {{ line }}
{%- endfor %}
 */
#include "{{ prefix }}.h"

const uint32_t {{ prefix }}[{{ upper }}_WORDS] = {
{%- for line in words.chunks(8) %}
    {% for word in line %}{{ "0x{:08x}U"|format(word) }}{% if !loop.last %}, {% endif %}{% endfor %},
{%- endfor %}
};
