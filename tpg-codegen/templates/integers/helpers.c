{% if let Some(table) = table %}
/* On an AVR, tables stay in flash. */
#ifdef __AVR__
#include <avr/pgmspace.h>
#define {{ upper }}_TABLE PROGMEM
#define {{ upper }}_WEIGHT(place) (({{ table.weight }})pgm_read_{% if table.weight == "int8_t" %}byte{% else %}word{% endif %}(place))
#define {{ upper }}_NUMBER(place) ((int32_t)pgm_read_dword(place))
#else
#define {{ upper }}_TABLE
#define {{ upper }}_WEIGHT(place) (*(place))
#define {{ upper }}_NUMBER(place) (*(place))
#endif

/* A row for each of {{ table.names }}, a column for each value of the state. */
static const {{ table.weight }} {{ prefix }}_weights[{{ table.rows.len() }}][{{ table.columns }}] {{ upper }}_TABLE = {
{%- for row in table.rows %}
    { {{ row }} },
{%- endfor %}
};
{%- for (name, values) in table.numbers %}
static const int32_t {{ prefix }}_{{ name }}[{{ table.rows.len() }}] {{ upper }}_TABLE = { {{ values }} };
{%- endfor %}
{% endif %}
{%- for (int, bits) in [("int32_t", ""), ("int64_t", "64")] %}

/* value / 2^bits, rounded down. No shift of a negative number: C leaves that to the compiler, which makes one shift of this. */
static {{ int }} {{ prefix }}_shift{{ bits }}({{ int }} value, uint32_t bits)
{
    return (value < 0) ? ~(~value >> bits) : (value >> bits);
}

/* a / b, rounded down, of a b that is not 0. */
static {{ int }} {{ prefix }}_divide{{ bits }}({{ int }} a, {{ int }} b)
{
    const {{ int }} quotient = a / b;

    return (((quotient * b) != a) && ((a < 0) != (b < 0))) ? (quotient - 1) : quotient;
}

/* a / b, rounded down. By 0, the greatest integer with the sign of a, and of 0 / 0 the lowest: as a bid, it loses. */
static {{ int }} {{ prefix }}_quotient{{ bits }}({{ int }} a, {{ int }} b)
{
    return (b != 0) ? {{ prefix }}_divide{{ bits }}(a, b) : ((a > 0) ? INT32_MAX : ((a < 0) ? -INT32_MAX : INT32_MIN));
}

static {{ int }} {{ prefix }}_min{{ bits }}({{ int }} a, {{ int }} b)
{
    return (a < b) ? a : b;
}

static {{ int }} {{ prefix }}_max{{ bits }}({{ int }} a, {{ int }} b)
{
    return (a > b) ? a : b;
}

static {{ int }} {{ prefix }}_abs{{ bits }}({{ int }} a)
{
    return (a < 0) ? -a : a;
}

static {{ int }} {{ prefix }}_negate_if_less{{ bits }}({{ int }} a, {{ int }} b)
{
    return (a < b) ? -a : a;
}

static {{ int }} {{ prefix }}_gate{{ bits }}({{ int }} a, {{ int }} b)
{
    return (b != 0) ? a : 0;
}

static {{ int }} {{ prefix }}_clamp{{ bits }}({{ int }} value, {{ int }} low, {{ int }} high)
{
    return (value > high) ? high : ((value < low) ? low : value);
}

{%- endfor %}
