#include "policies.h"
#include "platform.h"

#include <string.h>

{% if integers -%}
/* A number as a sensor would give it: cut off, and clipped; no number is 0. */
static int16_t counted(float value, float most)
{
    int16_t count = 0;

    if (value >= most) {
        count = (int16_t)most;
    } else if (value <= -most) {
        count = (int16_t)(-most);
    } else if ((value > -most) && (value < most)) {
        count = (int16_t)value;
    } else {
        /* no number */
    }
    return count;
}

{% endif -%}
{% for it in policies -%}
/* Not all fit into the flash of every core at once. */
#if (IN_IMAGE & {{ it.bit }}U) != 0U
static const float {{ it.name }}_low[] = { {% for value in it.low %}{{ value|fmt("{:?}") }}F, {% endfor %}};
static const float {{ it.name }}_step[] = { {% for value in it.step %}{{ value|fmt("{:?}") }}F, {% endfor %}};
{% if rust -%}
void rust_{{ it.name }}(const float *state, uint32_t *bits);

static uint32_t {{ it.name }}_answer(const float *state, uint32_t *bits)
{
    platform_count_from();
    rust_{{ it.name }}(state, bits);
    return platform_count();
}
{% else -%}
#include "{{ it.name }}.h"

static uint32_t {{ it.name }}_answer(const float *state, uint32_t *bits)
{
    {{ it.name }}_state_t seen;
    {{ it.name }}_action_t action;
    uint32_t count;
{%- if let Some(first) = it.memory %}
    {{ it.name }}_memory_t memory;

    memcpy(&memory, &state[{{ first }}], sizeof memory);
{%- endif %}
{% if integers -%}
{% for (field, place, most) in it.fields %}
    seen.{{ field }} = counted(state[{{ place }}], {{ most }}.0F);
{%- endfor %}
{%- else %}
    memcpy(&seen, state, sizeof seen);
{%- endif %}
    platform_count_from();
{%- if it.outputs.is_empty() %}
    action = {{ it.name }}_infer(&seen{% if it.memory.is_some() %}, &memory{% endif %});
    count = platform_count();
    bits[0] = (uint32_t)action;
{%- else %}
    {{ it.name }}_infer(&seen, {% if it.memory.is_some() %}&memory, {% endif %}&action);
    count = platform_count();
{%- if integers %}
{%- for output in it.outputs %}
    bits[{{ loop.index0 }}] = (uint32_t)(int32_t)action.{{ output }};
{%- endfor %}
{%- else %}
    memcpy(bits, &action, sizeof action);
{%- if it.memory.is_some() %}
    memcpy(&bits[{{ it.outputs.len() }}], &memory, sizeof memory);
{%- endif %}
{%- endif %}
{%- endif %}
    return count;
}
{% endif -%}
#endif

{% endfor -%}
const policy_t policies[] = {
{%- for it in policies %}
#if (IN_IMAGE & {{ it.bit }}U) != 0U
    { "{{ it.name }}", {{ it.inputs }}U, {{ it.answers }}U, {{ it.name }}_low, {{ it.name }}_step, {{ it.name }}_answer },
#endif
{%- endfor %}
};
const uint8_t policy_count = sizeof policies / sizeof policies[0];
