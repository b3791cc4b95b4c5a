{% if short_ln %}
/// The platform's logarithm, which takes its time to find that a negative number has none. Not inlined: LLVM would compute
/// it before it is known to matter.
#[inline(never)]
fn ln(x: {{ scalar }}) -> {{ scalar }} {
    if x < {{ zero }} { {{ scalar }}::NAN } else { System::ln(x) }
}
{% endif %}
{% if short_exp %}
/// The platform's exponential, which takes its time to find that a result is no number any more, or 0. Not inlined: LLVM
/// would compute it before it is known to matter.
#[inline(never)]
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
{% for name in plain %}
/// Not inlined: LLVM would compute it before it is known to matter.
#[inline(never)]
fn {{ name }}(x: {{ scalar }}) -> {{ scalar }} {
    {{ provider }}::{{ name }}(x)
}
{% endfor %}
{% if let Some(estimate) = ln_estimate %}
/// Not below the logarithm, and cheap: the bits of a number are a straight line between powers of two through it.
fn ln_upper(x: {{ scalar }}) -> {{ scalar }} {
    if x >= {{ scalar }}::MIN_POSITIVE && x <= {{ scalar }}::MAX {
        x.to_bits() as {{ signed }} as {{ scalar }} * {{ estimate.scale }} - {{ estimate.offset }}
    } else if x <= {{ zero }} {
        // Or NaN, which bids that.
        {{ scalar }}::NEG_INFINITY
    } else if x > {{ scalar }}::MAX {
        {{ scalar }}::INFINITY
    } else {
        {{ scalar }}::NAN
    }
}
{% endif %}
{% if let Some(estimate) = exp_estimate %}
/// Not below the exponential, and cheap: the bits of a number are a straight line between powers of two through its
/// logarithm.
fn exp_upper(x: {{ scalar }}) -> {{ scalar }} {
    if x >= {{ estimate.from }} && x <= {{ estimate.to }} {
        let whole = (x * {{ estimate.scale }}) as {{ signed }};
        {{ scalar }}::from_bits((whole as {{ unsigned }}).wrapping_add({{ estimate.offset }}))
    } else if x < {{ estimate.from }} {
        {{ estimate.below }}
    } else if x > {{ estimate.infinite_above }} {
        {{ scalar }}::INFINITY
    } else {
        {{ scalar }}::NAN
    }
}
{% endif %}
