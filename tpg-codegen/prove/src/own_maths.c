/* Own maths as the prover defines it: sin, cos, tan, ln, exp, atan and tanh of
 * binary32. Read by the prover's own reader of C; a test
 * compares it with tpg-runtime. Code is proven to compute the same terms, whatever its text. */
#include <stdint.h>
#include <string.h>

static uint32_t own_bits(float x)
{
    uint32_t bits;
    (void)memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float own_float(uint32_t bits)
{
    float x;
    (void)memcpy(&x, &bits, sizeof x);
    return x;
}

/* All ones where the top bit is set, else 0. */
static uint32_t own_mask(uint32_t bits)
{
    return 0U - (bits >> 31);
}

/* a where the mask is all ones, b where it is 0. */
static uint32_t own_choose(uint32_t mask, uint32_t a, uint32_t b)
{
    return b ^ ((a ^ b) & mask);
}

/* The bits of sin(a + offset - 1/8 turn), a given by its bits and the offset in 2^-32 turns. */
static uint32_t own_circle(uint32_t magnitude, uint32_t offset)
{
    /* floor(2/pi * 2^(8i + 5)) mod 2^32 */
    static const uint32_t two_over_pi[25] = {
        0x00000014U, 0x0000145fU, 0x00145f30U, 0x145f306dU, 0x5f306dc9U, 0x306dc9c8U,
        0x6dc9c882U, 0xc9c882a5U, 0xc882a53fU, 0x82a53f84U, 0xa53f84eaU, 0x3f84eafaU,
        0x84eafa3eU, 0xeafa3ea6U, 0xfa3ea69bU, 0x3ea69bb8U, 0xa69bb81bU, 0x9bb81b6cU,
        0xb81b6c52U, 0x1b6c52b3U, 0x6c52b327U, 0x52b32788U, 0xb3278872U, 0x27887208U,
        0x8872083fU
    };
    static const float polynomial[2][4] = {
        {-0.16666667f, 0.008333372f, -0.00019849911f, 2.800547e-6f}, /* sin r = r + r s P(s), s = r^2 */
        {-0.5f, 0.041666646f, -0.0013887311f, 2.4432566e-5f}         /* cos r = 1 + 1 s P(s) */
    };

    /* a = mantissa * 2^(8 byte + 125 - 150) */
    const uint32_t biased = magnitude >> 23;
    const uint32_t above = biased - 125U;
    const uint32_t exponent = above & ~own_mask(above);
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
    const uint32_t negative = own_mask(distance);
    const uint32_t upper_distance = distance ^ negative;
    const uint32_t lower_distance = angle_low ^ negative;
    const uint64_t distance_high = upper_distance;
    const uint64_t distance_low = lower_distance;

    /* times pi/2, in units of 2^-61 radians */
    const uint64_t half_pi = 0xc90fdaa2U;
    const uint64_t radians = (distance_high * half_pi) + ((distance_low * half_pi) >> 32);
    const uint64_t radians_high = radians >> 37;
    const uint64_t radians_low = radians >> 5;
    const uint32_t upper_part = (uint32_t)radians_high;
    const uint32_t lower_part = (uint32_t)radians_low;
    const float upper = (float)upper_part * 5.9604645e-8f;
    const float lower = (float)lower_part * 1.3877788e-17f;
    const uint32_t reduced = own_bits(upper + lower) | (distance & 0x80000000U);

    /* no reduction below 3/4 */
    const uint32_t small = own_mask(magnitude - 0x3f400000U);
    const float r = own_float(own_choose(small, magnitude, reduced));

    /* odd quadrants are the cosine's */
    const uint32_t odd = (turn >> 30) & 1U;
    const float base = own_float(own_choose(0U - odd, 0x3f800000U, own_bits(r)));
    const float *const c = polynomial[odd];
    const float s = r * r;
    const float zero = own_float(magnitude) * 0.0f;
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
    return own_bits(p) ^ (turn & 0x80000000U);
}

static float own_sin(float x)
{
    const uint32_t bits = own_bits(x);
    const uint32_t of_magnitude = own_circle(bits & 0x7fffffffU, 0x20000000U);
    return own_float(of_magnitude ^ (bits & 0x80000000U));
}

static float own_cos(float x)
{
    return own_float(own_circle(own_bits(x) & 0x7fffffffU, 0x60000000U));
}

static float own_tan(float x)
{
    return own_sin(x) / own_cos(x);
}

static float own_ln(float x)
{
    const uint32_t bits = own_bits(x);

    /* x = m * 2^exponent, sqrt(1/2) <= m < sqrt(2) */
    const uint32_t scaled = own_bits(x * 8388608.0f);
    const uint32_t small = own_mask(bits - 0x00800000U);
    const uint32_t normal = own_choose(small, scaled, bits);
    const uint32_t more = 23U & small;
    const int32_t bias = 127 + (int32_t)more;
    const uint32_t shifted = normal + (0x3f800000U - 0x3f3504f3U);
    const uint32_t biased = shifted >> 23;
    const int32_t unbiased = (int32_t)biased - bias;
    const float exponent = (float)unbiased;
    const float m = own_float((shifted & 0x007fffffU) + 0x3f3504f3U);

    /* ln(1 + f) = 2 artanh(s), s = f / (2 + f) */
    const float f = m - 1.0f;
    const float g = f + 2.0f;
    const float s = f / g;
    const float w = s * s;
    const float low = exponent * 1.4286068e-6f;
    const float high = exponent * 0.69314575f;

    /* infinity and NaN stay, zeros and what is negative have values of their own */
    const uint32_t before = bits - 1U;
    const uint32_t special = own_mask(before | (0x7f7ffffeU - before));
    const uint32_t zero = own_mask((bits & 0x7fffffffU) - 1U);
    const uint32_t signed_limit = bits | (own_mask(bits) & 0x7fc00000U);
    const uint32_t limit = own_choose(zero, 0xff800000U, signed_limit);
    float p = 0.2987083f * w;
    p = p + 0.39977583f;
    p = p * w;
    p = p + 0.66666776f;
    p = p * w;
    p = f - p;
    p = p * s;
    p = p - low;
    p = f - p;
    p = high + p;
    return own_float(own_choose(special, limit, own_bits(p)));
}

static float own_exp(float x)
{
    /* nothing changes beyond 104 */
    const uint32_t bits = own_bits(x);
    const uint32_t magnitude = bits & 0x7fffffffU;
    const uint32_t limited = own_choose(own_mask(magnitude - 0x42d00000U), magnitude, 0x42d00000U);
    const float a = own_float(limited | (bits & 0x80000000U));

    /* x = n ln 2 + r; adding 1.5 * 2^23 leaves the nearest integer in the low bits */
    const float quotient = a * 1.442695f;
    const float sum = quotient + 12582912.0f;
    const float n = sum - 12582912.0f;
    const float high = n * 0.69314575f;
    const float low = n * 1.4286068e-6f;
    const float rest = a - high;
    const float r = rest - low;

    /* 2^n as two powers of two */
    const uint32_t biased = own_bits(sum) - (0x4b400000U - 254U);
    const uint32_t half = biased >> 1;
    const float first = own_float(half << 23);
    const float second = own_float((biased - half) << 23);
    const uint32_t not_a_number = own_mask(0x7f800000U - magnitude);
    float p = 0.0013782504f * r;
    p = p + 0.008368675f;
    p = p * r;
    p = p + 0.041668963f;
    p = p * r;
    p = p + 0.16666521f;
    p = p * r;
    p = p + 0.4999999f;
    p = p * r;
    p = p * r;
    p = p + r;
    p = p + 1.0f;
    p = p * first;
    p = p * second;
    return own_float(own_bits(p) | (not_a_number & 0x7fc00000U));
}

/* The bits of the number for this range: below sqrt(2) - 1, above sqrt(2) + 1, or between them. */
static float own_of_range(uint32_t low, uint32_t high, float of_low, float of_middle, float of_high)
{
    const uint32_t upper = own_choose(high, own_bits(of_high), own_bits(of_middle));
    return own_float(own_choose(low, own_bits(of_low), upper));
}

static float own_atan(float x)
{
    const uint32_t bits = own_bits(x);
    const uint32_t magnitude = bits & 0x7fffffffU;
    const float a = own_float(magnitude);

    /* pi/4 + arctan((a - 1) / (a + 1)), pi/2 + arctan(-1 / a): whichever leaves a small argument */
    const uint32_t low = own_mask(magnitude - 0x3ed413cdU);
    const uint32_t high = own_mask(0x401a827aU - magnitude);
    const float above = own_of_range(low, high, a, a - 1.0f, -1.0f);
    const float below = own_of_range(low, high, 1.0f, a + 1.0f, a);
    const float offset = own_of_range(low, high, 0.0f, 0.7853982f, 1.5707964f);
    const float rest = own_of_range(low, high, 0.0f, -2.1855694e-8f, -4.371139e-8f);
    const float t = above / below;
    const float s = t * t;
    float p = 0.08054265f * s;
    p = p + -0.13877875f;
    p = p * s;
    p = p + 0.19977732f;
    p = p * s;
    p = p + -0.3333295f;
    p = p * s;
    p = p * t;
    p = p + rest;
    p = t + p;
    p = offset + p;
    return own_float(own_bits(p) | (bits & 0x80000000U));
}

static float own_tanh(float x)
{
    const uint32_t bits = own_bits(x);
    const uint32_t magnitude = bits & 0x7fffffffU;
    const float a = own_float(magnitude);

    /* 1 - 2 / (e^2a + 1), where that does not cancel */
    const float grown = own_exp(a + a);
    const float part = 2.0f / (grown + 1.0f);
    const float far = 1.0f - part;
    const uint32_t small = own_mask(magnitude - 0x3f0ccccdU); /* below 0.55 */
    const float s = a * a;
    float p = 0.0164371f * s;
    p = p + -0.052671693f;
    p = p * s;
    p = p + 0.13320726f;
    p = p * s;
    p = p + -0.33332947f;
    p = p * s;
    p = p * a;
    p = a + p;
    return own_float(own_choose(small, own_bits(p), own_bits(far)) | (bits & 0x80000000U));
}

typedef struct own_argument { float x; } own_argument_t;
typedef struct own_result { float y; } own_result_t;

static void own_sin_of(const own_argument_t *argument, own_result_t *result)
{
    result->y = own_sin(argument->x);
}

static void own_cos_of(const own_argument_t *argument, own_result_t *result)
{
    result->y = own_cos(argument->x);
}

static void own_tan_of(const own_argument_t *argument, own_result_t *result)
{
    result->y = own_tan(argument->x);
}

static void own_ln_of(const own_argument_t *argument, own_result_t *result)
{
    result->y = own_ln(argument->x);
}

static void own_exp_of(const own_argument_t *argument, own_result_t *result)
{
    result->y = own_exp(argument->x);
}

static void own_atan_of(const own_argument_t *argument, own_result_t *result)
{
    result->y = own_atan(argument->x);
}

static void own_tanh_of(const own_argument_t *argument, own_result_t *result)
{
    result->y = own_tanh(argument->x);
}
