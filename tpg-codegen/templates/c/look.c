/* A place in the image; row -1 if there is none. */
typedef struct {{ prefix }}_place {
    int32_t row;
    int32_t column;
    int32_t contrast;
} {{ prefix }}_place_t;
{% if look.has("first") %}
/* The first cell that is not 0. */
static {{ prefix }}_place_t {{ prefix }}_first(const uint8_t *image, uint32_t stride)
{
    {{ prefix }}_place_t place = { -1, -1, 0 };
    uint32_t row;
    uint32_t column;

    for (row = 0U; (row < {{ look.rows }}U) && (place.row < 0); row++) {
        for (column = 0U; (column < {{ look.columns }}U) && (place.row < 0); column++) {
            if (image[(row * stride) + (column * {{ look.channels }}U)] != 0U) {
                place.row = (int32_t)row;
                place.column = (int32_t)column;
            }
        }
    }
    return place;
}
{% endif %}
{%- if look.has("last") %}
/* The last cell that is not 0. */
static {{ prefix }}_place_t {{ prefix }}_last(const uint8_t *image, uint32_t stride)
{
    {{ prefix }}_place_t place = { -1, -1, 0 };
    uint32_t row;
    uint32_t column;

    for (row = {{ look.rows }}U; (row > 0U) && (place.row < 0); row--) {
        for (column = {{ look.columns }}U; (column > 0U) && (place.row < 0); column--) {
            if (image[((row - 1U) * stride) + ((column - 1U) * {{ look.channels }}U)] != 0U) {
                place.row = (int32_t)row - 1;
                place.column = (int32_t)column - 1;
            }
        }
    }
    return place;
}
{% endif %}
{%- if look.has("sum") %}
/* The sum of a window. */
static uint32_t {{ prefix }}_sum(const uint8_t *image, uint32_t stride, uint32_t height, uint32_t width)
{
    uint32_t sum = 0U;
    uint32_t row;
    uint32_t column;

    for (row = 0U; row < height; row++) {
        for (column = 0U; column < width; column++) {
            sum += image[(row * stride) + (column * {{ look.channels }}U)];
        }
    }
    return sum;
}
{% endif %}
{%- if look.has("window") %}
/* The middle of the square window with the greatest sum, or with the smallest; the first of equal ones. */
static {{ prefix }}_place_t {{ prefix }}_window(const uint8_t *image, uint32_t stride, uint32_t size, uint32_t is_dark)
{
    uint32_t mean = 0U;
    uint32_t best = (is_dark != 0U) ? 0xFFFFFFFFU : 0U;
    {{ prefix }}_place_t place = { (int32_t)(size / 2U), (int32_t)(size / 2U), 0 };
    uint32_t row;
    uint32_t column;

    for (row = 0U; row < {{ look.rows }}U; row++) {
        for (column = 0U; column < {{ look.columns }}U; column++) {
            mean += image[(row * stride) + (column * {{ look.channels }}U)];
        }
    }
    mean = ((mean * size) * size) / {{ look.rows * look.columns }}U;
    for (row = 0U; row <= ({{ look.rows }}U - size); row++) {
        for (column = 0U; column <= ({{ look.columns }}U - size); column++) {
            const uint32_t sum = {{ prefix }}_sum(&image[(row * stride) + (column * {{ look.channels }}U)], stride, size, size);

            if ((is_dark != 0U) ? (sum < best) : (sum > best)) {
                best = sum;
                place.row = (int32_t)(row + (size / 2U));
                place.column = (int32_t)(column + (size / 2U));
            }
        }
    }
    place.contrast = (is_dark != 0U) ? ((int32_t)mean - (int32_t)best) : ((int32_t)best - (int32_t)mean);
    return place;
}
{% endif %}
{%- if look.has("cell") %}
/* The cell so far down and to the right of a place; 0 outside the image. */
static uint8_t {{ prefix }}_cell(const uint8_t *image, uint32_t stride, {{ prefix }}_place_t from, int32_t down, int32_t right)
{
    const int32_t row = from.row + down;
    const int32_t column = from.column + right;

    if ((from.row < 0) || (row < 0) || (row >= {{ look.rows }}) || (column < 0) || (column >= {{ look.columns }})) {
        return 0U;
    }
    return image[((uint32_t)row * stride) + ((uint32_t)column * {{ look.channels }}U)];
}
{% endif %}
void {{ prefix }}_look(const uint8_t *image, uint32_t stride, {{ prefix }}_state_t *state)
{
{%- for find in look.finds %}
    const {{ prefix }}_place_t place_{{ loop.index0 }} = {{ prefix }}_{{ find.function }}(&image[{{ find.channel }}U], stride
{%- if find.size > 0 %}, {{ find.size }}U, {% if find.is_dark %}1U{% else %}0U{% endif %}{% endif %});
{%- endfor %}

{% for value in look.values %}
{%- match value.feature %}
{%- when Feature::Sum with { channel, row, column, height, width } %}
    state->{{ value.member }} = ({{ value.kind }}){{ prefix }}_sum(&image[({{ row }}U * stride) + {{ column * (look.channels as u32) + channel }}U], stride, {{ height }}U, {{ width }}U);
{%- when Feature::Row with (_) %}
    state->{{ value.member }} = ({{ value.kind }})place_{{ value.find }}.row;
{%- when Feature::Column with (_) %}
    state->{{ value.member }} = ({{ value.kind }})place_{{ value.find }}.column;
{%- when Feature::Contrast with (_) %}
    state->{{ value.member }} = ({{ value.kind }})place_{{ value.find }}.contrast;
{%- when Feature::Cell with { channel, down, right, .. } %}
    state->{{ value.member }} = ({{ value.kind }}){{ prefix }}_cell(&image[{{ channel }}U], stride, place_{{ value.find }}, {{ down }}, {{ right }});
{%- endmatch %}
{%- endfor %}
}
