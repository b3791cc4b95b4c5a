{%- let prefix = printer.prefix -%}
{%- let scalar = printer.scalar() -%}
{%- let upper = printer.upper() -%}
{#- exponent_end is the place of the exponent's lowest bit, counted from the top; from most on, every number is whole. -#}
{%- decl key -%}{%- decl signed -%}{%- decl unsigned_suffix -%}{%- decl top -%}{%- decl exponent_end -%}{%- decl sign -%}
{%- decl infinity -%}{%- decl zero -%}{%- decl one -%}{%- decl most -%}{%- decl most_bits -%}
{%- if f64 -%}
{%- let key = "uint64_t" -%}
{%- let signed = "int64_t" -%}
{%- let unsigned_suffix = "ULL" -%}
{%- let top = "63" -%}
{%- let exponent_end = "12" -%}
{%- let sign = "0x8000000000000000ULL" -%}
{%- let infinity = "0x7ff0000000000000ULL" -%}
{%- let zero = "0.0" -%}
{%- let one = "1.0" -%}
{%- let most = "4503599627370496.0" -%}
{%- let most_bits = "0x4330000000000000ULL" -%}
{%- else -%}
{%- let key = "uint32_t" -%}
{%- let signed = "int32_t" -%}
{%- let unsigned_suffix = "U" -%}
{%- let top = "31" -%}
{%- let exponent_end = "9" -%}
{%- let sign = "0x80000000U" -%}
{%- let infinity = "0x7f800000U" -%}
{%- let zero = "0.0f" -%}
{%- let one = "1.0f" -%}
{%- let most = "8388608.0f" -%}
{%- let most_bits = "0x4b000000U" -%}
{%- endif -%}

/* A number that the compiler does not know: it would compute the platform's function of it itself, and round another way. */
static {{ scalar }} {{ prefix }}_hidden({{ scalar }} number)
{
    const volatile {{ scalar }} hidden = number;
    return hidden;
}

{% if is_own %}
{% if f64 %}{% include "c/own_f64.c" %}{% else %}{% include "c/own_f32.c" %}{% endif %}
{% endif %}

/* The square root, by the FPU where there is one: a library tests for errno first. */
static float {{ prefix }}_root(float x)
{
#if defined(__GNUC__) && defined(__ARM_FP) && !defined(__aarch64__)
    float root;
    __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(x));
    return root;
#else
    return sqrtf(x);
#endif
}

{% if branch_free %}
{% include "c/keys.c" %}
{% else %}

static {{ scalar }} {{ prefix }}_negate_if_less({{ scalar }} a, {{ scalar }} b)
{
    return (a < b) ? -a : a;
}

static {{ scalar }} {{ prefix }}_min({{ scalar }} a, {{ scalar }} b)
{
    return (a < b) ? a : b;
}

static {{ scalar }} {{ prefix }}_max({{ scalar }} a, {{ scalar }} b)
{
    return (a > b) ? a : b;
}

/* a where b is not 0, else -0. */
static {{ scalar }} {{ prefix }}_gate({{ scalar }} a, {{ scalar }} b)
{
    return ((b >= {{ zero }}) && (b <= {{ zero }})) ? {% if f64 %}-0.0{% else %}-0.0f{% endif %} : a;
}

/* a / b, rounded down. By 0, the greatest integer with the sign of a, and of 0 / 0 the lowest. */
static {{ scalar }} {{ prefix }}_quotient({{ scalar }} a, {{ scalar }} b)
{
    const {{ scalar }} quotient = a / b;
    {{ scalar }} result = quotient;

    if ((b >= {{ zero }}) && (b <= {{ zero }})) {
        result = (a > {{ zero }}) ? {{ by_zero[0] }} : ((a < {{ zero }}) ? {{ by_zero[1] }} : {{ by_zero[2] }});
    } else if ((quotient > -{{ most }}) && (quotient < {{ most }})) {
        result = ({{ scalar }})({{ signed }})quotient;
        result = (result > quotient) ? (result - {{ one }}) : result;
    } else {
        /* whole as it is, or no number */
    }
    return result;
}

/* An output in its range. NaN fails both comparisons{% if let Some(nan) = same_nan %}, and becomes {{ nan }}{% endif %}. */
static {{ scalar }} {{ prefix }}_clamp({{ scalar }} value, {{ scalar }} low, {{ scalar }} high{% if same_nan.is_none() %}, {{ scalar }} nan{% endif %})
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : {% if let Some(nan) = same_nan %}{{ nan }}{% else %}nan{% endif %};
}

{% endif %}

{% include "c/fmod.c" %}

{% if short %}
/* The platform's logarithm, which is slow for negative arguments. */
static {{ scalar }} {{ prefix }}_ln({{ scalar }} x)
{
    return (x < {{ zero }}) ? {% if f64 %}(double)NAN{% else %}NAN{% endif %} : {{ printer.function("log") }}(x);
}
{% endif %}
{% if short %}
/* The platform's exponential, which is slow once the result over- or underflows. */
static {{ scalar }} {{ prefix }}_exp({{ scalar }} x)
{
    {{ scalar }} result;

    if (x > {{ self.literal(beyond.0) }}) {
        result = {% if f64 %}(double)INFINITY{% else %}INFINITY{% endif %};
    } else if (x < {{ self.literal(beyond.1) }}) {
        result = {{ zero }};
    } else {
        result = {{ printer.function("exp") }}(x);
    }
    return result;
}
{% endif %}

/* A cheap upper bound of the logarithm: the bits of a number are a straight line between powers of two through it. */
static double {{ prefix }}_ln_upper(double x)
{
    double bound = (double)NAN; /* no bound */

    if ((x >= DBL_MIN) && (x <= DBL_MAX)) {
        int64_t bits;

        (void)memcpy(&bits, &x, sizeof bits);
        bound = ((double)bits * {{ self.literal(&estimate::LN_SCALE) }}) - {{ self.literal(&estimate::LN_OFFSET) }};
    } else if (x <= 0.0) {
        bound = -(double)INFINITY; /* NaN also bids that */
    } else if (x > DBL_MAX) {
        bound = (double)INFINITY;
    } else {
        /* no change */
    }
    return bound;
}

/* A cheap upper bound of the exponential: the bits of a number are a straight line between powers of two through its
 * logarithm. */
static double {{ prefix }}_exp_upper(double x)
{
    double bound = (double)NAN; /* no bound */

    if ((x >= {{ self.literal(&estimate::EXP_BETWEEN.0) }}) && (x <= {{ self.literal(&estimate::EXP_BETWEEN.1) }})) {
        const double scaled = x * {{ self.literal(&estimate::EXP_SCALE) }};
        const int64_t whole = (int64_t)scaled;
        const uint64_t bits = (uint64_t)whole + {{ "{:#x}"|format(estimate::EXP_OFFSET) }}ULL;

        (void)memcpy(&bound, &bits, sizeof bound);
    } else if (x < {{ self.literal(&estimate::EXP_BETWEEN.0) }}) {
        bound = {{ self.literal(&estimate::EXP_BELOW) }};
    } else if (x > {{ self.literal(&estimate::EXP_INFINITE_ABOVE) }}) {
        bound = (double)INFINITY;
    } else {
        /* no change */
    }
    return bound;
}

{% if printer.leads %}
/* Compiled for size, comparisons of doubles are functions: on many processors each is a call. */
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define {{ upper }}_LEADER static __attribute__((noinline))
#elif defined(__GNUC__)
#define {{ upper }}_LEADER static inline __attribute__((always_inline))
#else
#define {{ upper }}_LEADER static inline
#endif

/* The best bid of a team so far, and its edge or way. */
typedef struct {{ prefix }}_lead {
    {{ scalar }} best;
    uint32_t winner;
} {{ prefix }}_lead_t;

/* A bid of a later edge than the others wins if none is higher. */
{{ upper }}_LEADER void {{ prefix }}_take({{ prefix }}_lead_t *lead, {{ scalar }} bid, uint32_t winner)
{
    if (bid >= lead->best) {
        lead->best = bid;
        lead->winner = winner;
    }
}

/* A bid wins if none is higher; of equal bids the later edge's wins. */
{{ upper }}_LEADER void {{ prefix }}_take_at({{ prefix }}_lead_t *lead, {{ scalar }} bid, uint32_t winner)
{
    if ((bid >= lead->best) && ((bid > lead->best) || (lead->winner < winner))) {
        lead->best = bid;
        lead->winner = winner;
    }
}

/* Tests whether a bid of a later edge than the others can win; also where the bound is NaN, which is none. */
{{ upper }}_LEADER uint32_t {{ prefix }}_can(const {{ prefix }}_lead_t *lead, {{ scalar }} bound)
{
    return (lead->best > bound) ? 0U : 1U;
}

/* The same for a bid of any edge. */
{{ upper }}_LEADER uint32_t {{ prefix }}_can_at(const {{ prefix }}_lead_t *lead, {{ scalar }} bound, uint32_t winner)
{
    return ((lead->best > bound) || ((lead->best >= bound) && (lead->winner >= winner))) ? 0U : 1U;
}

{% endif %}
