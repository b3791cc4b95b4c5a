/* Own maths in float: the same statements, and so the same bits, as tpg-runtime's ops::own::f32, where the
 * method and the error bounds are described. Needs round to nearest, FLT_EVAL_METHOD 0 or 16, and that nothing is fused. */

static uint32_t {{ prefix }}_bits(float x)
{
    uint32_t bits;
    (void)memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float {{ prefix }}_float(uint32_t bits)
{
    float x;
    (void)memcpy(&x, &bits, sizeof x);
    return x;
}

/* All ones where the top bit is set, else 0. */
static uint32_t {{ prefix }}_mask(uint32_t bits)
{
    return 0U - (bits >> 31);
}

/* a where the mask is all ones, b where it is 0. */
static uint32_t {{ prefix }}_choose(uint32_t mask, uint32_t a, uint32_t b)
{
    return b ^ ((a ^ b) & mask);
}

/* The bits of sin(a + offset - 1/8 turn), a given by its bits and the offset in 2^-32 turns. */
static uint32_t {{ prefix }}_circle(uint32_t magnitude, uint32_t offset)
{
    /* floor(2/pi * 2^(8i + 5)) mod 2^32 */
    static const uint32_t two_over_pi[25] = {
{%- for word in single::TWO_OVER_PI.iter().take(25) %}{% if loop.index0 % 6 == 0 %}
        {% else %} {% endif %}{{ "{:#010x}U"|format(word) }}{% if !loop.last %},{% endif %}{% endfor %}
    };
    static const float polynomial[2][4] = {
        { {%- for value in single::CIRCLE[0] %}{{ "{:?}f"|format(value) }}{% if !loop.last %}, {% endif %}{% endfor -%} }, /* sin r = r + r s P(s), s = r^2 */
        { {%- for value in single::CIRCLE[1] %}{{ "{:?}f"|format(value) }}{% if !loop.last %}, {% endif %}{% endfor -%} }         /* cos r = 1 + 1 s P(s) */
    };

    /* a = mantissa * 2^(8 byte + 125 - 150) */
    const uint32_t biased = magnitude >> 23;
    const uint32_t above = biased - 125U;
    const uint32_t exponent = above & ~{{ prefix }}_mask(above);
    const uint32_t byte = exponent >> 3;
    const uint32_t significand = ((magnitude & 0x007fffffU) | 0x00800000U) << (exponent & 7U);
    const uint64_t mantissa = significand;

    /* a * 2/pi modulo 4 in units of 2^-62 */
    const uint64_t high = (mantissa * two_over_pi[byte]) << 32;
    const uint64_t middle = mantissa * two_over_pi[byte + 4U];
    const uint64_t low = (mantissa * two_over_pi[byte + 8U]) >> 32;
    const uint64_t angle = high + middle + low;
    const uint64_t angle_upper = angle >> 32;
    const uint32_t angle_high = (uint32_t)angle_upper;
    const uint32_t angle_low = (uint32_t)angle;

    /* the quadrant, and the signed distance from its middle with its sign taken off */
    const uint32_t turn = angle_high + offset;
    const uint32_t distance = (turn & 0x3fffffffU) - 0x20000000U;
    const uint32_t negative = {{ prefix }}_mask(distance);
    const uint32_t upper_distance = distance ^ negative;
    const uint32_t lower_distance = angle_low ^ negative;
    const uint64_t distance_high = upper_distance;
    const uint64_t distance_low = lower_distance;

    /* times pi/2, in units of 2^-61 radians */
    const uint64_t half_pi = {{ "{:#x}U"|format(single::HALF_PI) }};
    const uint64_t radians = (distance_high * half_pi) + ((distance_low * half_pi) >> 32);
    const uint64_t radians_high = radians >> 37;
    const uint64_t radians_low = radians >> 5;
    const uint32_t upper_part = (uint32_t)radians_high;
    const uint32_t lower_part = (uint32_t)radians_low;
    const float upper = (float)upper_part * 5.9604645e-8f;
    const float lower = (float)lower_part * 1.3877788e-17f;
    const uint32_t reduced = {{ prefix }}_bits(upper + lower) | (distance & 0x80000000U);

    /* no reduction below 3/4 */
    const uint32_t small = {{ prefix }}_mask(magnitude - 0x3f400000U);
    const float r = {{ prefix }}_float({{ prefix }}_choose(small, magnitude, reduced));

    /* odd quadrants are the cosine's */
    const uint32_t odd = (turn >> 30) & 1U;
    const float base = {{ prefix }}_float({{ prefix }}_choose(0U - odd, 0x3f800000U, {{ prefix }}_bits(r)));
    const float *const c = polynomial[odd];
    const float s = r * r;
    const float zero = {{ prefix }}_float(magnitude) * 0.0f;
    float p = c[3] * s;
    p = p + c[2];
    p = p * s;
    p = p + c[1];
    p = p * s;
    p = p + c[0];
    p = p * s;
    p = p * base;
    p = p + zero;
    p = base + p;
    return {{ prefix }}_bits(p) ^ (turn & 0x80000000U);
}

static float {{ prefix }}_sin(float x)
{
    const uint32_t bits = {{ prefix }}_bits(x);
    const uint32_t of_magnitude = {{ prefix }}_circle(bits & 0x7fffffffU, 0x20000000U);
    return {{ prefix }}_float(of_magnitude ^ (bits & 0x80000000U));
}

static float {{ prefix }}_cos(float x)
{
    return {{ prefix }}_float({{ prefix }}_circle({{ prefix }}_bits(x) & 0x7fffffffU, 0x60000000U));
}

static float {{ prefix }}_tan(float x)
{
    return {{ prefix }}_sin(x) / {{ prefix }}_cos(x);
}

static float {{ prefix }}_ln(float x)
{
    const uint32_t bits = {{ prefix }}_bits(x);

    /* x = m * 2^exponent, sqrt(1/2) <= m < sqrt(2) */
    const uint32_t scaled = {{ prefix }}_bits(x * 8388608.0f);
    const uint32_t small = {{ prefix }}_mask(bits - 0x00800000U);
    const uint32_t normal = {{ prefix }}_choose(small, scaled, bits);
    const uint32_t more = 23U & small;
    const int32_t bias = 127 + (int32_t)more;
    const uint32_t shifted = normal + (0x3f800000U - 0x3f3504f3U);
    const uint32_t biased = shifted >> 23;
    const int32_t unbiased = (int32_t)biased - bias;
    const float exponent = (float)unbiased;
    const float m = {{ prefix }}_float((shifted & 0x007fffffU) + 0x3f3504f3U);

    /* ln(1 + f) = 2 artanh(s), s = f / (2 + f) */
    const float f = m - 1.0f;
    const float g = f + 2.0f;
    const float s = f / g;
    const float w = s * s;
    const float low = exponent * {{ "{:?}f"|format(single::LN_2_LOW) }};
    const float high = exponent * {{ "{:?}f"|format(single::LN_2_HIGH) }};

    /* infinity and NaN stay, zeros and what is negative have values of their own */
    const uint32_t before = bits - 1U;
    const uint32_t special = {{ prefix }}_mask(before | (0x7f7ffffeU - before));
    const uint32_t zero = {{ prefix }}_mask((bits & 0x7fffffffU) - 1U);
    const uint32_t signed_limit = bits | ({{ prefix }}_mask(bits) & 0x7fc00000U);
    const uint32_t limit = {{ prefix }}_choose(zero, 0xff800000U, signed_limit);
    float p = {{ "{:?}f"|format(single::LN[2]) }} * w;
    p = p + {{ "{:?}f"|format(single::LN[1]) }};
    p = p * w;
    p = p + {{ "{:?}f"|format(single::LN[0]) }};
    p = p * w;
    p = f - p;
    p = p * s;
    p = p - low;
    p = f - p;
    p = high + p;
    return {{ prefix }}_float({{ prefix }}_choose(special, limit, {{ prefix }}_bits(p)));
}

static float {{ prefix }}_exp(float x)
{
    /* nothing changes beyond 104 */
    const uint32_t bits = {{ prefix }}_bits(x);
    const uint32_t magnitude = bits & 0x7fffffffU;
    const uint32_t limited = {{ prefix }}_choose({{ prefix }}_mask(magnitude - 0x42d00000U), magnitude, 0x42d00000U);
    const float a = {{ prefix }}_float(limited | (bits & 0x80000000U));

    /* x = n ln 2 + r; adding 1.5 * 2^23 leaves the nearest integer in the low bits */
    const float quotient = a * {{ "{:?}f"|format(std::f32::consts::LOG2_E) }};
    const float sum = quotient + 12582912.0f;
    const float n = sum - 12582912.0f;
    const float high = n * {{ "{:?}f"|format(single::LN_2_HIGH) }};
    const float low = n * {{ "{:?}f"|format(single::LN_2_LOW) }};
    const float rest = a - high;
    const float r = rest - low;

    /* 2^n as two powers of two */
    const uint32_t biased = {{ prefix }}_bits(sum) - (0x4b400000U - 254U);
    const uint32_t half = biased >> 1;
    const float first = {{ prefix }}_float(half << 23);
    const float second = {{ prefix }}_float((biased - half) << 23);
    const uint32_t not_a_number = {{ prefix }}_mask(0x7f800000U - magnitude);
    float p = {{ "{:?}f"|format(single::EXP[4]) }} * r;
    p = p + {{ "{:?}f"|format(single::EXP[3]) }};
    p = p * r;
    p = p + {{ "{:?}f"|format(single::EXP[2]) }};
    p = p * r;
    p = p + {{ "{:?}f"|format(single::EXP[1]) }};
    p = p * r;
    p = p + {{ "{:?}f"|format(single::EXP[0]) }};
    p = p * r;
    p = p * r;
    p = p + r;
    p = p + 1.0f;
    p = p * first;
    p = p * second;
    return {{ prefix }}_float({{ prefix }}_bits(p) | (not_a_number & 0x7fc00000U));
}

/* The bits of the number for this range: below sqrt(2) - 1, above sqrt(2) + 1, or between them. */
static float {{ prefix }}_of_range(uint32_t low, uint32_t high, float of_low, float of_middle, float of_high)
{
    const uint32_t upper = {{ prefix }}_choose(high, {{ prefix }}_bits(of_high), {{ prefix }}_bits(of_middle));
    return {{ prefix }}_float({{ prefix }}_choose(low, {{ prefix }}_bits(of_low), upper));
}

static float {{ prefix }}_atan(float x)
{
    const uint32_t bits = {{ prefix }}_bits(x);
    const uint32_t magnitude = bits & 0x7fffffffU;
    const float a = {{ prefix }}_float(magnitude);

    /* pi/4 + arctan((a - 1) / (a + 1)), pi/2 + arctan(-1 / a): whichever leaves a small argument */
    const uint32_t low = {{ prefix }}_mask(magnitude - 0x3ed413cdU);
    const uint32_t high = {{ prefix }}_mask(0x401a827aU - magnitude);
    const float above = {{ prefix }}_of_range(low, high, a, a - 1.0f, -1.0f);
    const float below = {{ prefix }}_of_range(low, high, 1.0f, a + 1.0f, a);
    const float offset = {{ prefix }}_of_range(low, high, 0.0f, {{ "{:?}f"|format(single::QUARTERS[0][0]) }}, {{ "{:?}f"|format(single::QUARTERS[1][0]) }});
    const float rest = {{ prefix }}_of_range(low, high, 0.0f, {{ "{:?}f"|format(single::QUARTERS[0][1]) }}, {{ "{:?}f"|format(single::QUARTERS[1][1]) }});
    const float t = above / below;
    const float s = t * t;
    float p = {{ "{:?}f"|format(single::ATAN[3]) }} * s;
    p = p + {{ "{:?}f"|format(single::ATAN[2]) }};
    p = p * s;
    p = p + {{ "{:?}f"|format(single::ATAN[1]) }};
    p = p * s;
    p = p + {{ "{:?}f"|format(single::ATAN[0]) }};
    p = p * s;
    p = p * t;
    p = p + rest;
    p = t + p;
    p = offset + p;
    return {{ prefix }}_float({{ prefix }}_bits(p) | (bits & 0x80000000U));
}

static float {{ prefix }}_tanh(float x)
{
    const uint32_t bits = {{ prefix }}_bits(x);
    const uint32_t magnitude = bits & 0x7fffffffU;
    const float a = {{ prefix }}_float(magnitude);

    /* 1 - 2 / (e^2a + 1), where that does not cancel */
    const float grown = {{ prefix }}_exp(a + a);
    const float part = 2.0f / (grown + 1.0f);
    const float far = 1.0f - part;
    const uint32_t small = {{ prefix }}_mask(magnitude - 0x3f0ccccdU); /* below 0.55 */
    const float s = a * a;
    float p = {{ "{:?}f"|format(single::TANH[3]) }} * s;
    p = p + {{ "{:?}f"|format(single::TANH[2]) }};
    p = p * s;
    p = p + {{ "{:?}f"|format(single::TANH[1]) }};
    p = p * s;
    p = p + {{ "{:?}f"|format(single::TANH[0]) }};
    p = p * s;
    p = p * a;
    p = a + p;
    return {{ prefix }}_float({{ prefix }}_choose(small, {{ prefix }}_bits(p), {{ prefix }}_bits(far)) | (bits & 0x80000000U));
}

