#include "scenes.h"

const float centres[{{ centres.len() }}][3] = {
{%- for [x, y, z] in centres %}
    { {{ x|fmt("{:?}") }}F, {{ y|fmt("{:?}") }}F, {{ z|fmt("{:?}") }}F },
{%- endfor %}
};
const scene_t scenes[SCENES] = {
{%- for it in rollouts %}
    { { { {% for ticks in it.scene.start %}{{ ticks }}, {% endfor %}} },
      { {% for goal in it.scene.goals %}{ { {% for ticks in goal %}{{ ticks }}, {% endfor %}} }, {% endfor %}}, {{ it.scene.goals.len() }}U,
      { {% for ball in it.scene.balls %}{{ ball.radius|fmt("{:?}") }}F, {% endfor %}}, {{ it.scene.balls.len() }}U, {{ it.first }}U, {{ it.steps }}U },
{%- endfor %}
};
