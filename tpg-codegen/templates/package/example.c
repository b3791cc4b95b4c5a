/* Asks the policy about one state, after its self-test. */
#include "{{ it.name }}.h"

#include <stdio.h>

{{ entry }}
{
    const {{ it.name }}_state_t state = { {{ it.state_c }} }; /* the middle of every range */
{%- if it.memory > 0 %}
    {{ it.name }}_memory_t memory;
{%- endif %}
{%- if !it.outputs.is_empty() %}
    {{ it.name }}_action_t action;
{%- endif %}
    const unsigned long wrong = (unsigned long){{ it.name }}_selftest();

    printf("self-test: %lu wrong\n", wrong);
{%- if it.memory > 0 %}
    {{ it.name }}_reset(&memory);
{%- endif %}
{%- if it.outputs.is_empty() %}
    printf("action %u\n", (unsigned){{ it.name }}_infer(&state));
{%- else %}
    {{ it.name }}_infer(&state{% if it.memory > 0 %}, &memory{% endif %}, &action);
{%- for row in it.outputs %}
    printf("{{ row.name }} %g\n", (double)action.{{ row.field }});
{%- endfor %}
{%- endif %}
{%- if returns %}
    return (wrong == 0UL) ? 0 : 1;
{%- endif %}
}
