/* Decides for states from standard input: see tpg-codegen's verify::process. */
#include "{{ prefix }}.h"

#include <stdio.h>
#include <string.h>

#define LENGTH {{ state_length }}U
#define BATCH 1024U

static {{ scalar }} values[BATCH * LENGTH];
{%- if outputs == 0 %}
static uint16_t actions[BATCH];
{%- else if memory.is_empty() %}
static {{ prefix }}_action_t actions[BATCH];
{%- else %}
static struct {
    {{ prefix }}_action_t action;
    {{ prefix }}_memory_t memory;
} actions[BATCH];
{%- endif %}
{% if gegelati %}
{%- for (_, length) in sources %}
static {{ scalar }} source{{ loop.index }}[{{ length }}];
{{ scalar }} *in{{ loop.index }} = source{{ loop.index }};
{%- endfor %}
{%- endif %}

int main(void)
{
    unsigned char head[4];

    if ({{ prefix }}_selftest() != 0U) {
        return 3;
    }
    while (fread(head, 1U, 4U, stdin) == 4U) {
        const size_t count = (size_t)head[0] | ((size_t)head[1] << 8) | ((size_t)head[2] << 16);
        size_t index;

        if ((count > BATCH) || (fread(values, sizeof(values[0]), count * LENGTH, stdin) != count * LENGTH)) {
            return 1;
        }
        for (index = 0U; index < count; index++) {
            const {{ scalar }} *value = &values[index * LENGTH];
{%- if gegelati %}
{%- for (_, length) in sources %}
            memcpy(in{{ loop.index }}, value, sizeof(source{{ loop.index }}));
            value += {{ length }};
{%- endfor %}
            actions[index] = (uint16_t)inferenceTPG();
{%- else %}
            {{ prefix }}_state_t state;
{% for (name, length) in sources %}
            memcpy(state.{{ name }}, value, sizeof(state.{{ name }}));
            value += {{ length }};
{%- endfor %}
{%- if outputs == 0 %}
            actions[index] = {{ prefix }}_infer(&state);
{%- else %}
{%- if memory.is_empty() %}
            {{ prefix }}_infer(&state, &actions[index]);
{%- else %}
{%- for name in memory %}
            actions[index].memory.{{ name }} = *value;
            value++;
{%- endfor %}
            {{ prefix }}_infer(&state, &actions[index].memory, &actions[index].action);
{%- endif %}
{%- endif %}
{%- endif %}
        }
        if ((fwrite(actions, sizeof(actions[0]), count, stdout) != count) || (fflush(stdout) != 0)) {
            return 2;
        }
    }
    return 0;
}
