/*
{%- for line in banner %}
 * {{ line }}
{%- endfor %}
 */
#include "{{ prefix }}.h"

#include <float.h>
#include <math.h>
{%- if helpers.own_maths() %}
#include <string.h>
{%- endif %}

#ifdef __FAST_MATH__
#error "fast-math reorders operations and drops NaN: the policy would act differently"
#endif
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0){% if helpers.f64 %} && (FLT_EVAL_METHOD != 1){% endif %}
#error "{{ scalar }} expressions must be computed in {{ scalar }}: the policy would act differently"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#else
/* With GCC in GNU mode on a machine with fused multiply-add, pass -ffp-contract=off (-std=c99 implies it). */
#endif
{% if helpers.own_maths() %}
{% if helpers.f64 %}{% include "c/own_f64.c" %}{% else %}{% include "c/own_f32.c" %}{% endif %}
{% endif %}
{% if helpers.uses("negate_if_less") %}
static {{ scalar }} {{ prefix }}_negate_if_less({{ scalar }} a, {{ scalar }} b)
{
    return (a < b) ? -a : a;
}
{% endif %}
{% if helpers.uses("min") %}
static {{ scalar }} {{ prefix }}_min({{ scalar }} a, {{ scalar }} b)
{
    return (a < b) ? a : b;
}
{% endif %}
{% if helpers.uses("max") %}
static {{ scalar }} {{ prefix }}_max({{ scalar }} a, {{ scalar }} b)
{
    return (a > b) ? a : b;
}
{% endif %}
{% for program in programs %}
static {{ scalar }} {{ prefix }}_program_{{ program.label }}({{ parameter }})
{
{%- for statement in program.statements %}
    {{ statement }}
{%- endfor %}
{% if !gegelati && !program.reads_state %}
    (void)state;
{%- endif %}
    return {{ program.result }};
}
{% endfor %}
/* A bid as teams compare it: a NaN counts as minus infinity. */
static {{ scalar }} {{ prefix }}_bid({{ scalar }} value)
{
    return (isnan(value) != 0) ? ({{ scalar }})(-INFINITY) : value;
}

/* The place of the highest bid, of equal ones the last. */
static uint32_t {{ prefix }}_highest(const {{ scalar }} bids[], uint32_t count)
{
    uint32_t best = 0U;
    {{ scalar }} highest = {{ prefix }}_bid(bids[0]);
    uint32_t edge;

    for (edge = 1U; edge < count; edge++) {
        const {{ scalar }} challenger = {{ prefix }}_bid(bids[edge]);

        if (challenger >= highest) {
            best = edge;
            highest = challenger;
        }
    }
    return best;
}
{% for team in teams %}
static uint32_t {{ prefix }}_team_{{ team.label }}({{ parameter }})
{
    static const {{ vertex }} next[{{ team.programs.len() }}] = { {{ team.next }} };
    {{ scalar }} bids[{{ team.programs.len() }}];
{% for program in team.programs %}
    bids[{{ loop.index0 }}] = {{ prefix }}_program_{{ program }}({{ argument }});
{%- endfor %}
    return next[{{ prefix }}_highest(bids, {{ team.programs.len() }}U)];
}
{% endfor %}
/* Teams are numbered from 0, which is the root; the actions follow them. */
{% if gegelati %}
int inferenceTPG(void)
{% else %}
uint16_t {{ prefix }}_infer(const {{ prefix }}_state_t *state)
{% endif %}
{
    uint32_t vertex = 0U;
    uint32_t hop;

    for (hop = 0U; (hop < {{ upper }}_DEPTH) && (vertex < {{ upper }}_TEAMS); hop++) {
        switch (vertex) {
{%- for team in teams %}
        case {{ loop.index0 }}U:
            vertex = {{ prefix }}_team_{{ team.label }}({{ argument }});
            break;
{%- endfor %}
        default:
            vertex = {{ upper }}_TEAMS; /* never: every team has its case */
            break;
        }
    }
    vertex -= {{ upper }}_TEAMS;
    return ({% if gegelati %}int{% else %}uint16_t{% endif %})vertex;
}

#ifndef {{ upper }}_NO_SELFTEST
{% if gegelati %}
typedef struct {{ prefix }}_vector {
{%- for source in sources %}
    {{ scalar }} {{ source.name }}[{{ source.length }}];
{%- endfor %}
} {{ prefix }}_vector_t;
{% endif %}
uint32_t {{ prefix }}_selftest(void)
{
    static const {{ prefix }}_{% if gegelati %}vector{% else %}state{% endif %}_t states[{{ vectors.len() }}] = {
{%- for vector in vectors %}
        {{ vector.state }},
{%- endfor %}
    };
    static const uint16_t actions[{{ vectors.len() }}] = {
        {% for vector in vectors %}{{ vector.action }}U{% if !loop.last %}, {% endif %}{% endfor %}
    };
    uint32_t failures = 0U;
    uint32_t vector;
{%- if gegelati %}
{%- for source in sources %}
    {{ scalar }} *const caller{{ loop.index }} = in{{ loop.index }};
{%- endfor %}
{%- endif %}

    for (vector = 0U; vector < {{ vectors.len() }}U; vector++) {
{%- if gegelati %}
        {{ prefix }}_vector_t copy;

        copy = states[vector];
{%- for source in sources %}
        in{{ loop.index }} = copy.{{ source.name }};
{%- endfor %}
        if (inferenceTPG() != (int)actions[vector]) {
{%- else %}
        if ({{ prefix }}_infer(&states[vector]) != actions[vector]) {
{%- endif %}
            failures++;
        }
    }
{%- if gegelati %}
{%- for source in sources %}
    in{{ loop.index }} = caller{{ loop.index }};
{%- endfor %}
{%- endif %}
    return failures;
}
#endif
