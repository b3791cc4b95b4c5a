{% if short %}
/// The platform's logarithm, which is slow for negative arguments. Not inlined: LLVM would compute
/// it before it is known to matter.
#[inline(never)]
fn ln(x: {{ scalar }}) -> {{ scalar }} {
    if x < {{ zero }} { {{ scalar }}::NAN } else { System::ln(x) }
}
{% endif %}
{% if short %}
/// The platform's exponential, which is slow once the result over- or underflows. Not inlined: LLVM
/// would compute it before it is known to matter.
#[inline(never)]
fn exp(x: {{ scalar }}) -> {{ scalar }} {
    if x > {{ self.literal(beyond.0) }} {
        {{ scalar }}::INFINITY
    } else if x < {{ self.literal(beyond.1) }} {
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

/// A cheap upper bound of the logarithm: the bits of a number are a straight line between powers of two through it.
fn ln_upper(x: f64) -> f64 {
    if x >= f64::MIN_POSITIVE && x <= f64::MAX {
        x.to_bits() as i64 as f64 * {{ self.literal(&estimate::LN_SCALE) }} - {{ self.literal(&estimate::LN_OFFSET) }}
    } else if x <= 0.0 {
        // NaN also bids that.
        f64::NEG_INFINITY
    } else if x > f64::MAX {
        f64::INFINITY
    } else {
        f64::NAN
    }
}

/// A cheap upper bound of the exponential: the bits of a number are a straight line between powers of two through its
/// logarithm.
fn exp_upper(x: f64) -> f64 {
    if x >= {{ self.literal(&estimate::EXP_BETWEEN.0) }} && x <= {{ self.literal(&estimate::EXP_BETWEEN.1) }} {
        let whole = (x * {{ self.literal(&estimate::EXP_SCALE) }}) as i64;
        f64::from_bits((whole as u64).wrapping_add({{ "{:#x}"|format(estimate::EXP_OFFSET) }}))
    } else if x < {{ self.literal(&estimate::EXP_BETWEEN.0) }} {
        {{ self.literal(&estimate::EXP_BELOW) }}
    } else if x > {{ self.literal(&estimate::EXP_INFINITE_ABOVE) }} {
        f64::INFINITY
    } else {
        f64::NAN
    }
}

{% if printer.leads %}
/// The best bid of a team so far, and its edge or way. Where a
/// comparison is a call of its own, as on most processors of 32 bits, the functions keep code small.
struct Lead {
    best: {{ scalar }},
    winner: u32,
}

#[allow(dead_code, reason = "not every graph has bids of each kind")]
impl Lead {
    fn new(best: {{ scalar }}, winner: u32) -> Self {
        Self { best, winner }
    }

    /// A bid of a later edge than the others wins if none is higher.
    #[cfg_attr(target_pointer_width = "32", inline(never))]
    fn take(&mut self, bid: {{ scalar }}, winner: u32) {
        if bid >= self.best {
            self.best = bid;
            self.winner = winner;
        }
    }

    /// A bid wins if none is higher; of equal bids the later edge's wins.
    #[cfg_attr(target_pointer_width = "32", inline(never))]
    fn take_at(&mut self, bid: {{ scalar }}, winner: u32) {
        if bid >= self.best && (bid > self.best || self.winner < winner) {
            self.best = bid;
            self.winner = winner;
        }
    }

    /// Tests whether a bid of a later edge than the others can win; also where the bound is NaN, which is none.
    #[cfg_attr(target_pointer_width = "32", inline(never))]
    fn can(&self, bound: {{ scalar }}) -> bool {
        !(self.best > bound)
    }

    /// The same for a bid of any edge.
    #[cfg_attr(target_pointer_width = "32", inline(never))]
    fn can_at(&self, bound: {{ scalar }}, winner: u32) -> bool {
        !(self.best > bound || self.best >= bound && self.winner >= winner)
    }
}
{% endif %}
