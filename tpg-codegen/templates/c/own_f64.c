/* Own maths in double: the same statements, and so the same bits, as tpg-runtime's ops::own::f64, where the
 * method and the error bounds are described. Needs round to nearest, FLT_EVAL_METHOD 0, 1 or 16, and that nothing is fused. */

static uint64_t {{ prefix }}_bits(double x)
{
    uint64_t bits;
    (void)memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double {{ prefix }}_double(uint64_t bits)
{
    double x;
    (void)memcpy(&x, &bits, sizeof x);
    return x;
}

/* All ones where the top bit is set, else 0. */
static uint64_t {{ prefix }}_mask(uint64_t bits)
{
    return 0U - (bits >> 63);
}

/* a where the mask is all ones, b where it is 0. */
static uint64_t {{ prefix }}_choose(uint64_t mask, uint64_t a, uint64_t b)
{
    return b ^ ((a ^ b) & mask);
}

/* The upper half of a product, from 32-bit halves: C99 has no wider type. */
static uint64_t {{ prefix }}_multiply_high(uint64_t a, uint64_t b)
{
    const uint64_t mask = 0xffffffffU;
    const uint64_t a_low = a & mask;
    const uint64_t a_high = a >> 32;
    const uint64_t b_low = b & mask;
    const uint64_t b_high = b >> 32;
    const uint64_t low = a_low * b_low;
    const uint64_t first = (a_high * b_low) + (low >> 32);
    const uint64_t second = (a_low * b_high) + (first & mask);
    return (a_high * b_high) + (first >> 32) + (second >> 32);
}

/* 64 bits of 2/pi from a bit of the table on. */
static uint64_t {{ prefix }}_window(uint32_t bit)
{
    /* The bits of 2/pi: 64 zeros, then those behind the binary point. */
    static const uint32_t two_over_pi[39] = {
{%- for word in double::TWO_OVER_PI.iter() %}{% if loop.index0 % 6 == 0 %}
        {% else %} {% endif %}{{ "{:#010x}U"|format(word) }}{% if !loop.last %},{% endif %}{% endfor %}
    };

    const uint32_t word = bit >> 5;
    const uint32_t shift = bit & 31U;
    const uint64_t upper = two_over_pi[word];
    const uint64_t first = upper << 32;
    const uint64_t second = two_over_pi[word + 1U];
    const uint64_t third = two_over_pi[word + 2U];
    return ((first | second) << shift) | ((third << shift) >> 32);
}

/* The bits of sin(a + offset - 1/8 turn), a given by its bits and the offset in 2^-64 turns. */
static uint64_t {{ prefix }}_circle(uint64_t magnitude, uint64_t offset)
{
    static const double polynomial[2][7] = {
        /* sin r = r + r s P(s), s = r^2 */
        { {%- for value in double::CIRCLE[0] %}{{ "{:?}"|format(value) }}{% if loop.index == 5 %},
         {% else if !loop.last %}, {% endif %}{% endfor -%} },
        /* cos r = 1 + 1 s P(s) */
        { {%- for value in double::CIRCLE[1] %}{{ "{:?}"|format(value) }}{% if loop.index == 5 %},
         {% else if !loop.last %}, {% endif %}{% endfor -%} }
    };

    const uint64_t sign = (uint64_t)1U << 63;
    const uint64_t least_normal = (uint64_t)1U << 52;

    /* a = mantissa * 2^(exponent + 1021 - 1075) */
    const uint64_t biased = magnitude >> 52;
    const uint64_t above = biased - 1021U;
    const uint64_t kept = above & ~{{ prefix }}_mask(above);
    const uint32_t exponent = (uint32_t)kept;
    const uint64_t mantissa = (magnitude & (least_normal - 1U)) | least_normal;

    /* a * 2/pi modulo 4 in units of 2^-126 */
    const uint64_t first = {{ prefix }}_window(exponent + 8U);
    const uint64_t second = {{ prefix }}_window(exponent + 72U);
    const uint64_t third = {{ prefix }}_window(exponent + 136U);
    const uint64_t angle_below = {{ prefix }}_multiply_high(mantissa, third);
    const uint64_t angle_low = (mantissa * second) + angle_below;
    const uint64_t angle_carry = (angle_low < angle_below) ? (uint64_t)1U : (uint64_t)0U;
    const uint64_t angle_high = (mantissa * first) + {{ prefix }}_multiply_high(mantissa, second) + angle_carry;

    /* the quadrant, and the signed distance from its middle with its sign taken off */
    const uint64_t turn = angle_high + offset;
    const uint64_t distance = (turn & ((sign >> 1) - 1U)) - (sign >> 2);
    const uint64_t negative = {{ prefix }}_mask(distance);
    const uint64_t distance_high = distance ^ negative;
    const uint64_t distance_low = angle_low ^ negative;

    /* times pi/2, in units of 2^-125 radians */
    const uint64_t half_pi = ((uint64_t){{ "{:#x}U"|format(double::HALF_PI >> 32) }} << 32) | {{ "{:#x}U"|format(double::HALF_PI as u32) }};
    const uint64_t radians_below = {{ prefix }}_multiply_high(distance_low, half_pi);
    const uint64_t radians_low = (distance_high * half_pi) + radians_below;
    const uint64_t radians_carry = (radians_low < radians_below) ? (uint64_t)1U : (uint64_t)0U;
    const uint64_t radians_high = {{ prefix }}_multiply_high(distance_high, half_pi) + radians_carry;
    const uint64_t upper_part = radians_high >> 8;
    const uint64_t lower_part = (radians_high << 56) | (radians_low >> 8);
    const double upper = (double)upper_part * 1.1102230246251565e-16;
    const double lower = (double)lower_part * 6.018531076210112e-36;
    const uint64_t reduced = {{ prefix }}_bits(upper + lower) | (distance & sign);

    /* no reduction below 3/4 */
    const uint64_t three_quarters = (uint64_t)0x3fe80000U << 32;
    const uint64_t small = {{ prefix }}_mask(magnitude - three_quarters);
    const double r = {{ prefix }}_double({{ prefix }}_choose(small, magnitude, reduced));

    /* odd quadrants are the cosine's */
    const uint64_t parity = (turn >> 62) & 1U;
    const uint32_t odd = (uint32_t)parity;
    const double base = (odd == 1U) ? 1.0 : r;
    const double *const c = polynomial[odd];
    const double s = r * r;
    const double zero = {{ prefix }}_double(magnitude) * 0.0;
    double p = c[6] * s;
    p = p + c[5];
    p = p * s;
    p = p + c[4];
    p = p * s;
    p = p + c[3];
    p = p * s;
    p = p + c[2];
    p = p * s;
    p = p + c[1];
    p = p * s;
    p = p + c[0];
    p = p * s;
    p = p * base;
    p = p + zero;
    p = base + p;
    return {{ prefix }}_bits(p) ^ (turn & sign);
}

static double {{ prefix }}_sin(double x)
{
    const uint64_t sign = (uint64_t)1U << 63;
    const uint64_t bits = {{ prefix }}_bits(x);
    const uint64_t of_magnitude = {{ prefix }}_circle(bits & (sign - 1U), sign >> 2);
    return {{ prefix }}_double(of_magnitude ^ (bits & sign));
}

static double {{ prefix }}_cos(double x)
{
    const uint64_t sign = (uint64_t)1U << 63;
    return {{ prefix }}_double({{ prefix }}_circle({{ prefix }}_bits(x) & (sign - 1U), (sign >> 1) | (sign >> 2)));
}

static double {{ prefix }}_tan(double x)
{
    return {{ prefix }}_sin(x) / {{ prefix }}_cos(x);
}

static double {{ prefix }}_ln(double x)
{
    const uint64_t sign = (uint64_t)1U << 63;
    const uint64_t one = (uint64_t)0x3ff00000U << 32;
    const uint64_t half_root = ((uint64_t)0x3fe6a09eU << 32) | 0x667f3bcdU;
    const uint64_t least_normal = (uint64_t)1U << 52;
    const uint64_t infinity = (uint64_t)0x7ff00000U << 32;
    const uint64_t minus_infinity = (uint64_t)0xfff00000U << 32;
    const uint64_t not_a_number = (uint64_t)0x7ff80000U << 32;
    const uint64_t bits = {{ prefix }}_bits(x);

    /* x = m * 2^exponent, sqrt(1/2) <= m < sqrt(2) */
    const uint64_t scaled = {{ prefix }}_bits(x * 18014398509481984.0);
    const uint64_t small = {{ prefix }}_mask(bits - least_normal);
    const uint64_t normal = {{ prefix }}_choose(small, scaled, bits);
    const uint64_t more = 54U & small;
    const int32_t bias = 1023 + (int32_t)more;
    const uint64_t shifted = normal + (one - half_root);
    const uint64_t biased = shifted >> 52;
    const int32_t unbiased = (int32_t)biased - bias;
    const double exponent = (double)unbiased;
    const double m = {{ prefix }}_double((shifted & (least_normal - 1U)) + half_root);

    /* ln(1 + f) = 2 artanh(s), s = f / (2 + f) */
    const double f = m - 1.0;
    const double g = f + 2.0;
    const double s = f / g;
    const double w = s * s;
    const double low = exponent * {{ "{:?}"|format(double::LN_2_LOW) }};
    const double high = exponent * {{ "{:?}"|format(double::LN_2_HIGH) }};

    /* infinity and NaN stay, zeros and what is negative have values of their own */
    const uint64_t before = bits - 1U;
    const uint64_t special = {{ prefix }}_mask(before | ((infinity - 2U) - before));
    const uint64_t zero = {{ prefix }}_mask((bits & (sign - 1U)) - 1U);
    const uint64_t signed_limit = bits | ({{ prefix }}_mask(bits) & not_a_number);
    const uint64_t limit = {{ prefix }}_choose(zero, minus_infinity, signed_limit);
    double p = {{ "{:?}"|format(double::LN[6]) }} * w;
    p = p + {{ "{:?}"|format(double::LN[5]) }};
    p = p * w;
    p = p + {{ "{:?}"|format(double::LN[4]) }};
    p = p * w;
    p = p + {{ "{:?}"|format(double::LN[3]) }};
    p = p * w;
    p = p + {{ "{:?}"|format(double::LN[2]) }};
    p = p * w;
    p = p + {{ "{:?}"|format(double::LN[1]) }};
    p = p * w;
    p = p + {{ "{:?}"|format(double::LN[0]) }};
    p = p * w;
    p = f - p;
    p = p * s;
    p = p - low;
    p = f - p;
    p = high + p;
    return {{ prefix }}_double({{ prefix }}_choose(special, limit, {{ prefix }}_bits(p)));
}

static double {{ prefix }}_exp(double x)
{
    const uint64_t sign = (uint64_t)1U << 63;
    const uint64_t infinity = (uint64_t)0x7ff00000U << 32;
    const uint64_t quiet = (uint64_t)0x7ff80000U << 32;
    const uint64_t limit = (uint64_t)0x40875000U << 32;
    const uint64_t round_bits = (uint64_t)0x43380000U << 32;

    /* nothing changes beyond 746 */
    const uint64_t bits = {{ prefix }}_bits(x);
    const uint64_t magnitude = bits & (sign - 1U);
    const uint64_t limited = (magnitude < limit) ? magnitude : limit;
    const double a = {{ prefix }}_double(limited | (bits & sign));

    /* x = n ln 2 + r; adding 1.5 * 2^52 leaves the nearest integer in the low bits */
    const double quotient = a * {{ "{:?}"|format(std::f64::consts::LOG2_E) }};
    const double sum = quotient + 6755399441055744.0;
    const double n = sum - 6755399441055744.0;
    const double high = n * {{ "{:?}"|format(double::LN_2_HIGH) }};
    const double low = n * {{ "{:?}"|format(double::LN_2_LOW) }};
    const double rest = a - high;
    const double r = rest - low;

    /* 2^n as two powers of two */
    const uint64_t biased = {{ prefix }}_bits(sum) - (round_bits - 2046U);
    const uint64_t half = biased >> 1;
    const double first = {{ prefix }}_double(half << 52);
    const double second = {{ prefix }}_double((biased - half) << 52);
    const uint64_t not_a_number = {{ prefix }}_mask(infinity - magnitude);
    double p = {{ "{:?}"|format(double::EXP[9]) }} * r;
    p = p + {{ "{:?}"|format(double::EXP[8]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[7]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[6]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[5]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[4]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[3]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[2]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[1]) }};
    p = p * r;
    p = p + {{ "{:?}"|format(double::EXP[0]) }};
    p = p * r;
    p = p * r;
    p = p + r;
    p = p + 1.0;
    p = p * first;
    p = p * second;
    return {{ prefix }}_double({{ prefix }}_bits(p) | (not_a_number & quiet));
}

/* The bits of the number for this range: below sqrt(2) - 1, above sqrt(2) + 1, or between them. */
static double {{ prefix }}_of_range(uint64_t low, uint64_t high, double of_low, double of_middle, double of_high)
{
    const uint64_t upper = {{ prefix }}_choose(high, {{ prefix }}_bits(of_high), {{ prefix }}_bits(of_middle));
    return {{ prefix }}_double({{ prefix }}_choose(low, {{ prefix }}_bits(of_low), upper));
}

static double {{ prefix }}_atan(double x)
{
    const uint64_t bits = {{ prefix }}_bits(x);
    const uint64_t magnitude = bits & 0x7fffffffffffffffULL;
    const double a = {{ prefix }}_double(magnitude);

    /* pi/4 + arctan((a - 1) / (a + 1)), pi/2 + arctan(-1 / a): whichever leaves a small argument */
    const uint64_t low = {{ prefix }}_mask(magnitude - 0x3fda827999fcef32ULL);
    const uint64_t high = {{ prefix }}_mask(0x4003504f333f9de6ULL - magnitude);
    const double above = {{ prefix }}_of_range(low, high, a, a - 1.0, -1.0);
    const double below = {{ prefix }}_of_range(low, high, 1.0, a + 1.0, a);
    const double offset = {{ prefix }}_of_range(low, high, 0.0, {{ "{:?}"|format(double::QUARTERS[0][0]) }}, {{ "{:?}"|format(double::QUARTERS[1][0]) }});
    const double rest = {{ prefix }}_of_range(low, high, 0.0, {{ "{:?}"|format(double::QUARTERS[0][1]) }}, {{ "{:?}"|format(double::QUARTERS[1][1]) }});
    const double t = above / below;
    const double s = t * t;
    double p = {{ "{:?}"|format(double::ATAN[9]) }} * s;
    p = p + {{ "{:?}"|format(double::ATAN[8]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[7]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[6]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[5]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[4]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[3]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[2]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[1]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::ATAN[0]) }};
    p = p * s;
    p = p * t;
    p = p + rest;
    p = t + p;
    p = offset + p;
    return {{ prefix }}_double({{ prefix }}_bits(p) | (bits & 0x8000000000000000ULL));
}

static double {{ prefix }}_tanh(double x)
{
    const uint64_t bits = {{ prefix }}_bits(x);
    const uint64_t magnitude = bits & 0x7fffffffffffffffULL;
    const double a = {{ prefix }}_double(magnitude);

    /* 1 - 2 / (e^2a + 1), where that does not cancel */
    const double grown = {{ prefix }}_exp(a + a);
    const double part = 2.0 / (grown + 1.0);
    const double far = 1.0 - part;
    const uint64_t small = {{ prefix }}_mask(magnitude - 0x3fe199999999999aULL); /* below 0.55 */
    const double s = a * a;
    double p = {{ "{:?}"|format(double::TANH[9]) }} * s;
    p = p + {{ "{:?}"|format(double::TANH[8]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[7]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[6]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[5]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[4]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[3]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[2]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[1]) }};
    p = p * s;
    p = p + {{ "{:?}"|format(double::TANH[0]) }};
    p = p * s;
    p = p * a;
    p = a + p;
    return {{ prefix }}_double({{ prefix }}_choose(small, {{ prefix }}_bits(p), {{ prefix }}_bits(far)) | (bits & 0x8000000000000000ULL));
}

