/*
{%- for line in banner %}
 * {{ line }}
{%- endfor %}
 */
#include "{{ prefix }}.h"

{% include "c/flags.c" %}
{% include "c/contraction.c" %}
{% for layer in layers %}
static const int{{ bits }}_t weights_{{ loop.index0 }}[{{ layer.weights.len() }}] = {
{%- for line in layer.weights.chunks(20) %}
    {{ line|join(", ") }},
{%- endfor %}
};
static const int32_t bias_{{ loop.index0 }}[{{ layer.outputs }}] = { {{ layer.bias|join(", ") }} };
static const int16_t factor_{{ loop.index0 }}[{{ layer.outputs }}] = { {{ layer.factor|join(", ") }} };
static const uint8_t shift_{{ loop.index0 }}[{{ layer.outputs }}] = { {{ layer.shift|join(", ") }} };
{% endfor %}
{%- if policy.is_scaled() %}
static const float offset[{{ policy.inputs.len() }}] = { {% for input in policy.inputs %}{{ "{:?}F"|format(input.offset) }}{% if !loop.last %}, {% endif %}{% endfor %} };
static const float scale[{{ policy.inputs.len() }}] = { {% for input in policy.inputs %}{{ "{:?}F"|format(input.scale) }}{% if !loop.last %}, {% endif %}{% endfor %} };
{% endif %}
{%- if !values.is_empty() %}
static const float least[{{ values.len() }}] = { {% for value in values %}{{ "{:?}F"|format(value.min) }}{% if !loop.last %}, {% endif %}{% endfor %} };
static const float most[{{ values.len() }}] = { {% for value in values %}{{ "{:?}F"|format(value.max) }}{% if !loop.last %}, {% endif %}{% endfor %} };
static const float span[{{ values.len() }}] = { {% for value in values %}{{ "{:?}F"|format(value.max - value.min) }}{% if !loop.last %}, {% endif %}{% endfor %} };
{% endif %}
{%- if !table.is_empty() %}
/* tanh(k/32) in multiples of 1/16384. */
static const uint16_t tanh_table[{{ table.len() }}] = {
{%- for line in table.chunks(20) %}
    {{ line|join(", ") }},
{%- endfor %}
};

/* tanh of a number of 1/2048 in multiples of 1/16384, linear between the values of the table. */
static int32_t tanh_of(int32_t argument)
{
    uint32_t magnitude = argument < 0 ? (uint32_t)-argument : (uint32_t)argument;
    uint32_t place = magnitude / 64U;
    int32_t value = 16384;
    if (place + 1U < {{ table.len() }}U) {
        uint32_t low = tanh_table[place];
        value = (int32_t)(low + ((tanh_table[place + 1U] - low) * (magnitude % 64U) + 32U) / 64U);
    }
    return argument < 0 ? -value : value;
}
{% endif %}
{%- if self.has_clamp() %}
static int32_t clamp_of(int32_t argument)
{
    return argument > 16384 ? 16384 : argument < -16384 ? -16384 : argument;
}
{% endif %}
/* An input in multiples of 1/4096: to nearest, halves away from 0, clipped; 0 for NaN. */
static int16_t integer(float value)
{
    float scaled = value * 4096.0f;
    if (scaled != scaled) {
        return 0;
    }
    scaled = scaled < 0.0f ? scaled - 0.5f : scaled + 0.5f;
    if (scaled >= 32767.0f) {
        return 32767;
    }
    return scaled <= -32768.0f ? (int16_t)-32768 : (int16_t)scaled;
}

/* (accumulator * factor + 2^(shift - 1)) >> shift, rounded down, clipped. */
static int16_t rescaled(int32_t accumulator, int16_t factor, uint8_t shift, int16_t low)
{
    int64_t value = (int64_t)accumulator * factor + ((int64_t)1 << (shift - 1));
    value = value >= 0 ? value >> shift : -1 - ((-1 - value) >> shift);
    return (int16_t)(value > 32767 ? 32767 : value < low ? low : value);
}

/* A layer: the exact sum of products of each row, which cannot overflow, rescaled. */
static void layer(const int{{ bits }}_t *weights, const int32_t *bias, const int16_t *factor, const uint8_t *shift, int inputs,
                  int outputs, const int16_t *from, int16_t *to, int16_t low)
{
    int row;
    for (row = 0; row < outputs; row++) {
        int32_t sum = bias[row];
        int column;
        for (column = 0; column < inputs; column++) {
            sum += (int32_t)weights[column] * from[column];
        }
        weights += inputs;
        to[row] = rescaled(sum, factor[row], shift[row], low);
    }
}

{% if values.is_empty() %}uint16_t {{ prefix }}_infer(const {{ prefix }}_state_t *state)
{% else %}void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_action_t *action)
{% endif %}{
    int16_t a[{{ self.widest() }}];
    int16_t b[{{ self.widest() }}];
    int i;
{%- if values.is_empty() %}
    int best = 0;
{%- endif %}
    for (i = 0; i < {{ policy.inputs.len() }}; i++) {
        a[i] = integer({% if policy.is_scaled() %}(state->values[i] - offset[i]) * scale[i]{% else %}state->values[i]{% endif %});
    }
{%- for layer in layers %}
    layer(weights_{{ loop.index0 }}, bias_{{ loop.index0 }}, factor_{{ loop.index0 }}, shift_{{ loop.index0 }}, {{ layer.inputs }}, {{ layer.outputs }}, {{ arrays[loop.index0 % 2] }}, {{ arrays[loop.index % 2] }}, {{ layer.low }});
{%- endfor %}
{%- if values.is_empty() %}
    for (i = 1; i < {{ outputs }}; i++) {
        if ({{ arrays[layers.len() % 2] }}[i] > {{ arrays[layers.len() % 2] }}[best]) {
            best = i;
        }
    }
    return (uint16_t)best;
{%- else %}
{%- for value in values %}
    i = {% if value.squash == Squash::Tanh %}tanh_of{% else %}clamp_of{% endif %}({{ arrays[layers.len() % 2] }}[{{ loop.index0 }}] * {% if value.squash == Squash::Tanh %}{{ 1 << (11 - value.exponent) }}{% else %}{{ 1 << (14 - value.exponent) }}{% endif %});
    action->values[{{ loop.index0 }}] = most[{{ loop.index0 }}];
    if (i < 16384) {
        float value = least[{{ loop.index0 }}] + span[{{ loop.index0 }}] * ((float)(i + 16384) * (0.5f / 16384.0f));
        action->values[{{ loop.index0 }}] = value > most[{{ loop.index0 }}] ? most[{{ loop.index0 }}] : value;
    }
{%- endfor %}
{%- endif %}
}
