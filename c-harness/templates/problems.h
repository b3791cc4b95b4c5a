#ifndef PROBLEMS_H
#define PROBLEMS_H

#include "tpg_runtime.h"

#include <math.h>

typedef struct problem {
    tpg_pose_t start;
    float target[3];
} problem_t;

#define TOLERANCE_MM {{ tolerance|fmt("{:?}") }}F
/* Fewer of them are run on slow cores. */
#ifndef PROBLEMS
#define PROBLEMS {{ count }}U
#endif
#ifndef PARTS
#define PARTS {{ parts }}U
#endif
{% for it in starts %}
static const tpg_settings_t {{ it.name }}_settings = {
    {{ it.settings.hand_back_after }}U,
{%- if it.settings.separation.is_finite() %}
    {{ it.settings.separation|fmt("{:?}") }}F,
{%- else %}
    INFINITY,
{%- endif %}
    {{ it.guard }}
};
#define {{ it.name|upper }}_ACTIONS {{ it.actions }}U
static const problem_t {{ it.name }}_problems[] = {
{%- for task in it.tasks %}
    { { { {% for ticks in task.start.0 %}{{ ticks }}, {% endfor %}} }, { {% for mm in task.target %}{{ (*mm as f32)|fmt("{:?}") }}F, {% endfor %}} },
{%- endfor %}
};
{% endfor %}
#endif
