/* Policies in one program; its argument says which one decides for states from standard input: see tpg-codegen's
 * verify::process. */
{% for policy in policies -%}
#include "{{ policy.prefix }}.c"
{% endfor %}
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BATCH 1024U

{% for policy in policies %}
{%- if policy.gegelati %}
{%- for (_, length) in policy.sources %}
static {{ policy.scalar }} source{{ loop.index }}[{{ length }}];
{{ policy.scalar }} *in{{ loop.index }} = source{{ loop.index }};
{%- endfor %}
{%- endif %}

static int serve_{{ policy.prefix }}(void)
{
{%- if policy.integers.is_some() && policy.outputs > 0 %}
    static int32_t actions[BATCH][{{ policy.outputs }}];
{%- else if policy.outputs == 0 %}
    static uint16_t actions[BATCH];
{%- else if policy.memory.is_empty() %}
    static {{ policy.prefix }}_action_t actions[BATCH];
{%- else %}
    static struct {
        {{ policy.prefix }}_action_t action;
        {{ policy.prefix }}_memory_t memory;
    } actions[BATCH];
{%- endif %}
    static {{ policy.scalar }} values[BATCH * {{ policy.state_length }}U];
    unsigned char head[4];

    if ({{ policy.prefix }}_selftest() != 0U) {
        return 3;
    }
    while (fread(head, 1U, 4U, stdin) == 4U) {
        const size_t count = (size_t)head[0] | ((size_t)head[1] << 8) | ((size_t)head[2] << 16);
        const size_t length = count * {{ policy.state_length }}U;
        size_t index;

        if ((count > BATCH) || (fread(values, sizeof(values[0]), length, stdin) != length)) {
            return 1;
        }
        for (index = 0U; index < count; index++) {
            const {{ policy.scalar }} *value = &values[index * {{ policy.state_length }}U];
{%- if policy.gegelati %}
{%- for (_, length) in policy.sources %}
            memcpy(in{{ loop.index }}, value, sizeof(source{{ loop.index }}));
            value += {{ length }};
{%- endfor %}
            actions[index] = (uint16_t)inferenceTPG();
{%- else %}
            {{ policy.prefix }}_state_t state;
{%- if let Some(integers) = policy.integers %}
            size_t place;
{%- for (name, length) in policy.sources %}
            for (place = 0U; place < {{ length }}U; place++) {
                state.{{ name }}{% if *length > 1 %}[place]{% endif %} = ({{ integers.sources[loop.index0] }})*value;
                value++;
            }
{%- endfor %}
{%- if policy.outputs == 0 %}
            actions[index] = (uint16_t){{ policy.prefix }}_infer(&state);
{%- else %}
            {{ policy.prefix }}_action_t action;
{%- if policy.memory.is_empty() %}
            {{ policy.prefix }}_infer(&state, &action);
{%- else %}
            {{ policy.prefix }}_memory_t memory;
{%- for name in policy.memory %}
            memory.{{ name }} = *value;
            value++;
{%- endfor %}
            {{ policy.prefix }}_infer(&state, &memory, &action);
{%- endif %}
            place = 0U;
{%- for name in integers.outputs %}
            actions[index][place] = action.{{ name }};
            place++;
{%- endfor %}
{%- for name in policy.memory %}
            actions[index][place] = memory.{{ name }};
            place++;
{%- endfor %}
{%- endif %}
{%- else %}
{% for (name, length) in policy.sources %}
            memcpy(&state.{{ name }}, value, sizeof(state.{{ name }}));
            value += {{ length }};
{%- endfor %}
{%- if policy.outputs == 0 %}
            actions[index] = (uint16_t){{ policy.prefix }}_infer(&state);
{%- else if policy.memory.is_empty() %}
            {{ policy.prefix }}_infer(&state, &actions[index]);
{%- else %}
{%- for name in policy.memory %}
            actions[index].memory.{{ name }} = *value;
            value++;
{%- endfor %}
            {{ policy.prefix }}_infer(&state, &actions[index].memory, &actions[index].action);
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
{%- if let Some([bytes, row]) = policy.image %}

static int look_{{ policy.prefix }}(void)
{
    static {{ policy.scalar }} values[{{ bytes }}];
    static uint8_t image[{{ bytes }}];
    unsigned char head[4];

    while ((fread(head, 1U, 4U, stdin) == 4U) && (fread(values, sizeof(values[0]), {{ bytes }}U, stdin) == {{ bytes }}U)) {
        {{ policy.prefix }}_state_t state;
        size_t place;

        memset(&state, 0, sizeof(state));
        for (place = 0U; place < {{ bytes }}U; place++) {
            image[place] = (uint8_t)values[place];
        }
        {{ policy.prefix }}_look(image, {{ row }}U, &state);
{%- if policy.integers.is_some() %}
        {
            int32_t seen[{{ policy.state_length - policy.memory.len() }}];
            size_t count = 0U;
{%- for (name, length) in policy.sources %}
            for (place = 0U; place < {{ length }}U; place++) {
                seen[count] = state.{{ name }}{% if *length > 1 %}[place]{% endif %};
                count++;
            }
{%- endfor %}
            if ((fwrite(seen, sizeof(seen), 1U, stdout) != 1U) || (fflush(stdout) != 0)) {
                return 2;
            }
        }
{%- else %}
        if ((fwrite(&state, sizeof(state), 1U, stdout) != 1U) || (fflush(stdout) != 0)) {
            return 2;
        }
{%- endif %}
    }
    return 0;
}
{%- endif %}
{% endfor %}
int main(int argc, char **argv)
{
    switch ((argc > 1) ? atoi(argv[1]) : -1) {
{%- for policy in policies %}
    case {{ loop.index0 }}:
        return serve_{{ policy.prefix }}();
{%- if policy.image.is_some() %}
    case {{ loop.index0 + policies.len() }}:
        return look_{{ policy.prefix }}();
{%- endif %}
{%- endfor %}
    default:
        return 4;
    }
}
