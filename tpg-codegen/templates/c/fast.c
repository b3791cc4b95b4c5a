{% if functions.len() > 1 %}
/* Teams are numbered so that every one comes after all that lead to it; the actions follow them. {{ rule }} */
{%- else if has_order %}
/* {{ rule }} Every team comes after all that lead to it. */
{%- else %}
/* {{ rule }} */
{%- endif %}
{%- for function in functions %}
{%- if functions.len() > 1 %}

{% endif %}
{{ function.head }}
{
{%- if !leaves.is_empty() || answers_in_place %}
{%- for output in outputs %}
    {{ scalar }} {{ output.variable }};
{%- endfor %}
{% endif %}
{%- if !function.reads_state %}

    (void)state;
{%- endif %}
{% if !function.entries.is_empty() %}
{% for (number, label) in function.entries %}    {% if !loop.first %}} else {% endif %}if (start == {{ number }}U) {
        goto team_{{ label }};
{% endfor %}    } else {
        /* never: every team that may be asked for has a number */
    }
{% endif %}
{% for team in function.teams %}
{%- if function.is_entered(team.view.label) %}
team_{{ team.view.label }}:
{%- endif %}
{%- if function.teams.len() > 1 %}
    {
{%- endif %}
{%- if let Some(first) = team.view.first %}
{%- for statement in first.statements %}
        {{ statement }}
{%- endfor %}
{%- endif %}
{%- if team.keeps_winner %}
{%- if let Some(first) = team.view.first %}
{%- if leads %}
        {{ prefix }}_lead_t lead = { {{ first.value }}, {{ first.rank }} };
{%- else %}
        {{ scalar }} best = {{ first.value }};
        {{ team.winner_type }} {{ team.view.winner }} = {{ first.rank }};
{%- endif %}
{%- else if leads %}
        {{ prefix }}_lead_t lead = { {{ lowest }}, {{ team.view.initial }} };
{%- else %}
        {{ scalar }} best = {{ lowest }};
        {{ team.winner_type }} {{ team.view.winner }} = {{ team.view.initial }};
{%- endif %}
{%- endif %}
{%- for bid in team.view.eager %}
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}
{%- if team.keeps_winner %}{% include "c/fast_win.c" %}
{% endif %}
{%- endfor %}
{%- for bid in team.view.lazy %}
{%- for statement in bid.before %}
        {{ statement }}
{%- endfor %}
{%- if let Some(considered) = bid.considered %}

        if ({{ considered }}) {
{%- endif %}
{%- for statement in bid.bound %}
        {{ statement }}
{%- endfor %}

        {% if let Some(guard) = bid.guard %}if ({{ guard }}) {% endif %}{
{%- for statement in bid.statements %}
            {{ statement }}
{%- endfor %}
{%- include "c/fast_win.c" %}
        }
{%- if bid.considered.is_some() %}
        }
{%- endif %}
{%- endfor %}

{% for line in team.decision %}
{{ line }}
{%- endfor %}
{%- if function.teams.len() > 1 %}
    }
{%- endif %}
{% endfor %}
{%- for leaf in leaves %}

{%- if function.is_entered_leaf(leaf.label) %}
leaf_{{ leaf.label }}:
{%- endif %}
    {
{%- for statement in leaf.statements %}
        {{ statement }}
{%- endfor %}
{% for value in leaf.values %}
        {{ outputs[loop.index0].variable }} = {{ value }};
{%- endfor %}
    }
{%- if !loop.last %}
    goto answered;
{% endif %}
{% endfor %}
{%- if leaves.len() > 1 %}
answered:
{%- endif %}
{%- if !leaves.is_empty() || answers_in_place %}
{% for assignment in assignments %}
    {{ assignment }}
{%- endfor %}
{%- endif %}
}
{% endfor %}
{% if functions.len() > 1 %}
{% if outputs.is_empty() -%}
{{ entry.head }}
{%- else -%}
static uint32_t {{ prefix }}_leaf(const {{ entry.state }} *state)
{%- endif %}
{
    uint32_t vertex = {{ prefix }}_walk_0(state, 0U);
{% for function in functions %}
{%- if !loop.first %}
    if (vertex < {{ function.end }}U) {
        vertex = {{ prefix }}_walk_{{ loop.index0 }}(state, vertex);
    }
{%- endif %}
{%- endfor %}
    vertex -= {{ upper }}_TEAMS;
{%- if outputs.is_empty() %}
    return ({{ entry.action }})vertex;
{%- else %}
    return vertex;
{%- endif %}
}
{{ over_functions }}
{% endif %}
