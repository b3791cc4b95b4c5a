{% if own && (uses_sin || uses_cos || uses_ln || uses_exp) %}
{% if f64 %}{% include "c/own_f64.c" %}{% else %}{% include "c/own_f32.c" %}{% endif %}
{% endif %}
{% if branch_free %}
{% include "c/keys.c" %}
{% else %}
{% if uses_negate_if_less %}
static {{ scalar }} {{ prefix }}_negate_if_less({{ scalar }} a, {{ scalar }} b)
{
    return (a < b) ? -a : a;
}
{% endif %}
{% if uses_min %}
static {{ scalar }} {{ prefix }}_min({{ scalar }} a, {{ scalar }} b)
{
    return (a < b) ? a : b;
}
{% endif %}
{% if uses_max %}
static {{ scalar }} {{ prefix }}_max({{ scalar }} a, {{ scalar }} b)
{
    return (a > b) ? a : b;
}
{% endif %}
{% endif %}
{% if let Some(call) = short_ln %}
/* The platform's logarithm, which takes its time to find that a negative number has none. */
static {{ scalar }} {{ prefix }}_ln({{ scalar }} x)
{
    return (x < {% if f64 %}0.0{% else %}0.0F{% endif %}) ? {% if f64 %}(double)NAN{% else %}NAN{% endif %} : {{ call }}(x);
}
{% endif %}
{% if let Some(short) = short_exp %}
/* The platform's exponential, which takes its time to find that a result is no number any more, or 0. */
static {{ scalar }} {{ prefix }}_exp({{ scalar }} x)
{
    {{ scalar }} result;

    if (x > {{ short.infinite_above }}) {
        result = {% if f64 %}(double)INFINITY{% else %}INFINITY{% endif %};
    } else if (x < {{ short.zero_below }}) {
        result = {% if f64 %}0.0{% else %}0.0F{% endif %};
    } else {
        result = {{ short.call }}(x);
    }
    return result;
}
{% endif %}
{% for upper in uppers %}
/* Not below the {% if upper.logarithm %}logarithm{% else %}exponential{% endif %}, and cheap. */
static {{ scalar }} {{ prefix }}_{{ upper.name }}_upper({{ scalar }} x)
{
    {{ scalar }} bound = {{ upper.beyond }};
{% if upper.logarithm %}
    if (x < {% if f64 %}0.0{% else %}0.0F{% endif %}) {
        bound = {% if f64 %}-(double)INFINITY{% else %}-INFINITY{% endif %}; /* NaN, which bids that */
    } else{% else %}
    {% endif %}
    {%- for (up_to, value) in upper.steps %} if (x <= {{ up_to }}) {
        bound = {{ value }};
    } else{% endfor %} {
        /* as it is, for NaN too */
    }
    return bound;
}
{% endfor %}
