/* The graph of {{ prefix }}.h, and the network of {{ network }}.h where it asks: link both. */
#ifndef {{ upper }}_DECIDE_H
#define {{ upper }}_DECIDE_H

#include "{{ prefix }}.h"
#include "{{ network }}.h"

/* The action for a state: one of the graph's own. */
static inline {{ prefix }}_action_t {{ prefix }}_decide(const {{ prefix }}_state_t *state)
{
    const {{ prefix }}_action_t action = {{ prefix }}_infer(state);

    if (action == {{ upper }}_ASKS_{{ ask }}) {
        const {{ network }}_state_t seen = { {
{%- for row in inputs.chunks(3) %}
            {{ row|join(", ") }}{% if !loop.last %},{% endif %}
{%- endfor %}
        } };
        return ({{ prefix }}_action_t){{ network }}_infer(&seen);
    }
    return action;
}

#endif
