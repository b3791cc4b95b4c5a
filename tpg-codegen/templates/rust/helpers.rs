{% if short_ln %}
/// The platform's logarithm, which takes its time to find that a negative number has none.
fn ln(x: {{ scalar }}) -> {{ scalar }} {
    if x < {{ zero }} { {{ scalar }}::NAN } else { System::ln(x) }
}
{% endif %}
{% if short_exp %}
/// The platform's exponential, which takes its time to find that a result is no number any more, or 0.
fn exp(x: {{ scalar }}) -> {{ scalar }} {
    if x > {{ infinite_above }} {
        {{ scalar }}::INFINITY
    } else if x < {{ zero_below }} {
        {{ zero }}
    } else {
        System::exp(x)
    }
}
{% endif %}
{% for upper in uppers %}
/// Not below the {% if upper.logarithm %}logarithm{% else %}exponential{% endif %}, and cheap.
fn {{ upper.name }}_upper(x: {{ scalar }}) -> {{ scalar }} {
    {% if upper.logarithm %}if x < {{ zero }} {
        // NaN, which bids that.
        {{ scalar }}::NEG_INFINITY
    } else {% endif %}{% for (up_to, value) in upper.steps %}if x <= {{ up_to }} {
        {{ value }}
    } else {% endfor %}{
        {{ upper.beyond }}
    }
}
{% endfor %}
