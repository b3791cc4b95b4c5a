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
{%- for (_, length, kind) in policy.sources %}
static {{ kind }} source{{ loop.index }}[{{ length }}];
{{ kind }} *in{{ loop.index }} = source{{ loop.index }};
{%- endfor %}
{%- endif %}

static int serve_{{ policy.prefix }}(void)
{
{%- if policy.outputs == 0 %}
    static uint16_t actions[BATCH];
{%- else %}
    static double actions[BATCH][{{ policy.outputs }}];
{%- endif %}
    static double values[BATCH * {{ policy.state_length }}U];
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
            const double *value = &values[index * {{ policy.state_length }}U];
            size_t place;
{%- if policy.gegelati %}
{%- for (_, length, kind) in policy.sources %}
            for (place = 0U; place < {{ length }}U; place++) {
                in{{ loop.index }}[place] = ({{ kind }})*value;
                value++;
            }
{%- endfor %}
            actions[index] = (uint16_t)inferenceTPG();
{%- else %}
            {{ policy.prefix }}_state_t state;
{%- for (name, length, kind) in policy.sources %}
            for (place = 0U; place < {{ length }}U; place++) {
                state.{{ name }}{% if *length > 1 %}[place]{% endif %} = ({{ kind }})*value;
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
{%- for (name, _, kind) in policy.memory %}
            memory.{{ name }} = ({{ kind }})*value;
            value++;
{%- endfor %}
            {{ policy.prefix }}_infer(&state, &memory, &action);
{%- endif %}
            place = 0U;
{%- for name in policy.answers %}
            actions[index][place] = (double)action.{{ name }};
            place++;
{%- endfor %}
{%- for (name, _, _) in policy.memory %}
            actions[index][place] = (double)memory.{{ name }};
            place++;
{%- endfor %}
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
    static double values[{{ bytes }}];
    static uint8_t image[{{ bytes }}];
    unsigned char head[4];

    while ((fread(head, 1U, 4U, stdin) == 4U) && (fread(values, sizeof(values[0]), {{ bytes }}U, stdin) == {{ bytes }}U)) {
        {{ policy.prefix }}_state_t state;
        double seen[{{ policy.state_length - policy.memory.len() }}];
        size_t count = 0U;
        size_t place;

        memset(&state, 0, sizeof(state));
        for (place = 0U; place < {{ bytes }}U; place++) {
            image[place] = (uint8_t)values[place];
        }
        {{ policy.prefix }}_look(image, {{ row }}U, &state);
{%- for (name, length, _) in policy.sources %}
        for (place = 0U; place < {{ length }}U; place++) {
            seen[count] = (double)state.{{ name }}{% if *length > 1 %}[place]{% endif %};
            count++;
        }
{%- endfor %}
        if ((fwrite(seen, sizeof(seen), 1U, stdout) != 1U) || (fflush(stdout) != 0)) {
            return 2;
        }
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
