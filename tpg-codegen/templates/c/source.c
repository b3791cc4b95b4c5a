{%- let prefix = printer.prefix -%}
{%- let gegelati = printer.gegelati -%}
{%- let f64 = printer.graph.scalar() == ScalarType::F64 -%}
{%- let system_maths = printer.graph.maths() == MathsProvider::System -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() -%}
{%- let entry = printer.entry() -%}
/*
{%- for line in banner %}
 * {{ line }}
{%- endfor %}
 */
#include "{{ prefix }}.h"

{% if !printer.integers %}
#include <float.h>
{%- if needs_math %}
#include <math.h>
{%- endif %}
{%- if needs_string %}
#include <string.h>
{%- endif %}

{% include "c/flags.c" %}
/* 16 only widens types narrower than float. */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16){% if f64 %} && (FLT_EVAL_METHOD != 1){% endif %}
#error "{{ scalar }} expressions must be computed in {{ scalar }}: the policy would act differently"
#endif
{% include "c/contraction.c" %}
{% endif %}
{%- if let Some((teams, depth)) = walk %}
/* Teams, and how many of them decide at most in one inference. */
#define {{ upper }}_TEAMS {{ teams }}U
#define {{ upper }}_DEPTH {{ depth }}U
{% endif %}
{{ helpers }}
{%- if !parts.1.is_empty() %}
/* A state and the memory as one; an answer and the next memory as one. */
typedef struct {{ prefix }}_view {
{%- for source in sources %}
    {{ source.kind }} {{ source.member() }};
{%- endfor %}
} {{ entry.state }};

typedef struct {{ prefix }}_answer {
{%- for output in outputs %}
    {{ output.kind }} {{ output.field }};
{%- endfor %}
} {{ entry.answer }};
{% endif %}
{{ body }}
{%- if !parts.1.is_empty() %}

void {{ prefix }}_reset({{ prefix }}_memory_t *memory)
{
{%- for value in parts.1 %}
    memory->{{ value.field }} = {{ value.initial }};
{%- endfor %}
}

void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_memory_t *memory, {{ prefix }}_action_t *action)
{
    {{ entry.state }} view;
    {{ entry.answer }} answer;
{% for statement in observed %}
    {{ statement }}
{%- endfor %}
{%- for value in parts.1 %}
    view.{{ value.field }} = memory->{{ value.field }};
{%- endfor %}
    {{ entry.function }}(&view, &answer);
{%- for output in parts.0 %}
    action->{{ output.field }} = answer.{{ output.field }};
{%- endfor %}
{%- for value in parts.1 %}
    memory->{{ value.field }} = answer.{{ value.field }};
{%- endfor %}
}
{% endif %}
{%- if !look.is_empty() %}
{{ look }}
{% endif %}
#ifndef {{ upper }}_NO_SELFTEST
{% if gegelati %}
typedef struct {{ prefix }}_vector {
{%- for source in sources %}
    {{ scalar }} {{ source.field }}[{{ source.length }}];
{%- endfor %}
} {{ prefix }}_vector_t;
{% endif %}
{% if !printer.integers %}
{% include "c/arithmetic.c" %}
{% endif %}

uint32_t {{ prefix }}_selftest(void)
{
    static const {% if gegelati %}{{ prefix }}_vector_t{% else %}{{ entry.state }}{% endif %} states[{{ vectors.len() }}] = {
{%- for (state, _) in vectors %}
        {{ state }},
{%- endfor %}
    };
    static const {% if !outputs.is_empty() %}{{ entry.answer }}{% else if gegelati %}uint16_t{% else %}{{ entry.action }}{% endif %} actions[{{ vectors.len() }}] = {
{%- for (_, answer) in vectors %}
        {{ answer }},
{%- endfor %}
    };
{%- if system_maths %}
    /* Read anew: a compiler that knew the states would compute the platform's maths itself, and round another way. */
    const {% if gegelati %}{{ prefix }}_vector_t{% else %}{{ entry.state }}{% endif %} *const volatile hidden = states;
{%- endif %}
    uint32_t failures = {% if printer.integers %}0U{% else %}{{ prefix }}_arithmetic(){% endif %};
    uint32_t vector;
{%- if gegelati %}
{%- for source in sources %}
    {{ scalar }} *const caller{{ loop.index }} = in{{ loop.index }};
{%- endfor %}
{%- endif %}

    for (vector = 0U; vector < {{ vectors.len() }}U; vector++) {
{%- if gegelati %}
        {{ prefix }}_vector_t copy;

        copy = {% if system_maths %}hidden{% else %}states{% endif %}[vector];
{%- for source in sources %}
        in{{ loop.index }} = copy.{{ source.field }};
{%- endfor %}
        if (inferenceTPG() != (int)actions[vector]) {
{%- else if outputs.is_empty() %}
        if ({{ entry.function }}(&{% if system_maths %}hidden{% else %}states{% endif %}[vector]) != actions[vector]) {
{%- else %}
        {{ entry.answer }} action;

        {{ entry.function }}(&{% if system_maths %}hidden{% else %}states{% endif %}[vector], &action);
        if ({% for output in outputs %}{% if !loop.first %} ||
            {% endif %}!((action.{{ output.field }} >= actions[vector].{{ output.field }}) && (action.{{ output.field }} <= actions[vector].{{ output.field }})){% endfor %}) {
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
