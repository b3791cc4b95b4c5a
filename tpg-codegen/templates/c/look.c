/* A place in the image; row -1 if there is none. */
typedef struct {{ prefix }}_place {
    int32_t row;
    int32_t column;
    int32_t contrast;
} {{ prefix }}_place_t;
{% if !look.windows.is_empty() %}
/* The brightest window, and the darkest. */
typedef struct {{ prefix }}_windows {
    {{ prefix }}_place_t bright;
    {{ prefix }}_place_t dark;
} {{ prefix }}_windows_t;
{% endif %}
{%- if look.has("first") %}
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
{%- for window in look.windows %}
/* The middle of a window, of which so many follow. */
static {{ prefix }}_place_t {{ prefix }}_middle_{{ window.size }}(int32_t left, int32_t contrast)
{
    const int32_t number = {{ window.count() - 1 }} - left;
    const {{ prefix }}_place_t place = { (number / {{ window.across }}) + {{ window.size / 2 }}, (number % {{ window.across }}) + {{ window.size / 2 }}, contrast };

    return place;
}

/* The windows of {{ window.size }} by {{ window.size }} cells with the greatest and with the smallest sum; the first of equal ones. */
static {{ prefix }}_windows_t {{ prefix }}_windows_{{ window.size }}(const uint8_t *image, uint32_t stride)
{
    {{ prefix }}_windows_t found;
    int32_t left = {{ window.count() }}; /* windows that follow, below the sum: one comparison finds the first of equal ones */
    int32_t high = -1;
    int32_t low = INT32_MAX;
    uint32_t total = 0U;
    int32_t mean;
    uint32_t row;
    uint32_t column;

    for (row = 0U; row < {{ window.down }}U; row++) {
        const uint8_t *const cells = &image[row * stride];
{%- for before in window.before() %}
        uint32_t column_{{ before }} = (uint32_t)cells[{{ before * (look.channels as u32) }}U]
{%- for down in window.before() %} + cells[{{ before * (look.channels as u32) }}U + ({{ down + 1 }}U * stride)]{% endfor %};
{%- endfor %}
{% for before in window.before() %}
        total += cells[{{ before * (look.channels as u32) }}U];
{%- endfor %}
        for (column = {{ window.size - 1 }}U; column < {{ look.columns }}U; column++) {
            const uint8_t *const cell = &cells[column * {{ look.channels }}U];
            const uint32_t newest = (uint32_t)cell[0]{% for down in window.before() %} + cell[{{ down + 1 }}U * stride]{% endfor %};
            const int32_t sum = (int32_t)(newest{% for before in window.before() %} + column_{{ before }}{% endfor %}) * 65536;

            total += cell[0];
            left--;
            high = ((sum + left) > high) ? (sum + left) : high;
            low = ((sum - left) < low) ? (sum - left) : low;
{%- for before in window.before() %}
            column_{{ before }} = {% if loop.last %}newest{% else %}column_{{ before + 1 }}{% endif %};
{%- endfor %}
        }
    }
    for (row = {{ window.down }}U; row < {{ look.rows }}U; row++) {
        for (column = 0U; column < {{ look.columns }}U; column++) {
            total += image[(row * stride) + (column * {{ look.channels }}U)];
        }
    }
    mean = (int32_t)((total * {{ window.size * window.size }}U) / {{ look.rows * look.columns }}U);
    found.bright = {{ prefix }}_middle_{{ window.size }}(high % 65536, (high / 65536) - mean);
    left = (low + 65535) / 65536;
    found.dark = {{ prefix }}_middle_{{ window.size }}((left * 65536) - low, mean - left);
    return found;
}
{% endfor %}
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
    const {{ prefix }}_{% if find.size > 0 %}windows{% else %}place{% endif %}_t {% if find.size > 0 %}windows{% else %}place{% endif %}_{{ loop.index0 }} = {{ prefix }}_{{ find.function }}{% if find.size > 0 %}_{{ find.size }}{% endif %}(&image[{{ find.channel }}U], stride);
{%- endfor %}

{% for value in look.values %}
{%- match value.feature %}
{%- when Feature::Sum with { channel, row, column, height, width } %}
    state->{{ value.member }} = ({{ value.kind }}){{ prefix }}_sum(&image[({{ row }}U * stride) + {{ column * (look.channels as u32) + channel }}U], stride, {{ height }}U, {{ width }}U);
{%- when Feature::Row with (_) %}
    state->{{ value.member }} = ({{ value.kind }}){{ value.place }}.row;
{%- when Feature::Column with (_) %}
    state->{{ value.member }} = ({{ value.kind }}){{ value.place }}.column;
{%- when Feature::Contrast with (_) %}
    state->{{ value.member }} = ({{ value.kind }}){{ value.place }}.contrast;
{%- when Feature::Cell with { channel, down, right, .. } %}
    state->{{ value.member }} = ({{ value.kind }}){{ prefix }}_cell(&image[{{ channel }}U], stride, {{ value.place }}, {{ down }}, {{ right }});
{%- endmatch %}
{%- endfor %}
}
