{%- let prefix = printer.prefix -%}
{%- let gegelati = printer.gegelati -%}
{%- let system_maths = printer.graph.maths() == MathsProvider::System -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() -%}
/*
{%- for line in banner %}
 * {{ line }}
{%- endfor %}
 */
#ifndef {{ upper }}_H
#define {{ upper }}_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

{% if outputs.is_empty() && gegelati %}
/* The actions:
{%- for (_, name) in actions %}
 * {{ loop.index0 }} {{ name }}
{%- endfor %}
 */
#define {{ upper }}_ACTIONS {{ actions.len() }}U
{%- else if outputs.is_empty() %}
/* The actions. */
typedef enum {{ prefix }}_action {
{%- for (constant, name) in actions %}
    {{ constant }} = {{ loop.index0 }}{% if !loop.last %},{% endif %}{% if !name.is_empty() %} /* {{ name }} */{% endif %}
{%- endfor %}
} {{ prefix }}_action_t;
#define {{ upper }}_ACTIONS {{ actions.len() }}U
{%- for (name, number) in asks %}
#define {{ upper }}_ASKS_{{ name }} {{ actions[*number].0 }}
{%- endfor %}
{%- else %}
#define {{ upper }}_OUTPUTS {{ outputs.len() }}U
{%- endif %}
{% if gegelati %}
/* What the policy sees, as GEGELATI's generated code declares it. The caller defines these pointers. */
{%- for source in sources %}
extern {{ scalar }} *in{{ loop.index }}; /* {{ source.name }}: {{ source.length }} value{% if source.length != 1 %}s{% endif %}, {{ source.meaning }} */
{%- endfor %}

/* The action for the values that in1, in2, ... point at now. */
int inferenceTPG(void);
{% else %}
{%- if printer.integers %}
/* What the policy sees, in counts. Every value that the types hold is legal{% if look.is_some() %}; of an image, every one that {{ prefix }}_look writes{% endif %}. */
{%- else %}
/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
{%- endif %}
typedef struct {{ prefix }}_state {
{%- for source in sources %}
    {{ source.kind }} {{ source.member() }}; /* {% if source.field != source.name %}{{ source.name }}: {% endif %}{{ source.meaning }} */
{%- endfor %}
} {{ prefix }}_state_t;

{%- if outputs.is_empty() %}

/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
{{ prefix }}_action_t {{ prefix }}_infer(const {{ prefix }}_state_t *state);
{%- else %}

/* The values that the policy answers, {% if printer.integers %}in counts, each in its range{% else %}each in its range and never NaN{% endif %}. */
typedef struct {{ prefix }}_action {
{%- for output in outputs %}
    {{ output.kind }} {{ output.field }}; /* {% if output.field != output.name %}{{ output.name }}: {% endif %}{{ output.meaning }} */
{%- endfor %}
} {{ prefix }}_action_t;

{%- if memory.is_empty() %}

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_action_t *action);
{%- else %}

/* The values that the policy carries from one decision to the next, each in its range{% if !printer.integers %} and never NaN{% endif %}. */
typedef struct {{ prefix }}_memory {
{%- for value in memory %}
    {{ value.kind }} {{ value.field }}; /* {% if value.field != value.name %}{{ value.name }}: {% endif %}{{ value.meaning }}; at first {{ value.nan }} */
{%- endfor %}
} {{ prefix }}_memory_t;

/* Sets the memory as it is before the first decision of an episode. */
void {{ prefix }}_reset({{ prefix }}_memory_t *memory);

/* The answer to a state, and the next memory. Reentrant: no globals, no side effect but *memory and *action. */
void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_memory_t *memory, {{ prefix }}_action_t *action);
{%- endif %}
{%- endif %}
{% if let Some(look) = look %}
{% include "c/look.h" %}
{% endif %}
{%- if let Some(arm) = arm %}
/* For tpg_policy_t of tpg_runtime.h: the arm's sources that make up a state, and what each action moves, in ticks. */
#define {{ upper }}_SOURCES { {{ arm.sources.join(", ") }} }
#define {{ upper }}_SOURCE_COUNT {{ arm.sources.len() }}U
#define {{ upper }}_MOVES { {{ arm.moves.join(", ") }} }
{% endif %}
{%- endif %}
#ifndef {{ upper }}_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
{%- if let Some(quality) = quality %}
 * {{ quality }}
{%- endif %}
{%- if system_maths %}
 * The graph uses the platform's sin, cos, log and exp: another libm than the generator's may differ in the last bit.
 */
{%- else if quality.is_some() %}
 */
{%- else %} */{% endif %}
uint32_t {{ prefix }}_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
