{% if functions.len() > 1 %}
/* Teams are numbered so that every one comes after all that lead to it; the actions follow them. */
{% else %}
/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */
{% endif %}
{% for function in functions %}
{% if functions.len() > 1 -%}
static uint32_t {{ prefix }}_walk_{{ loop.index0 }}(const {{ entry.state }} *state, uint32_t start)
{%- else -%}
{{ entry.head }}
{%- endif %}
{
{%- if leaves.is_empty() %}
    uint32_t vertex;
{%- else %}
{%- for output in outputs %}
    {{ scalar }} {{ output.variable() }};
{%- endfor %}
{%- endif %}
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
{%- if functions.len() > 1 || !loop.first %}
team_{{ team.label }}:
{%- endif %}
    {
{%- if team.ways.len() > 1 %}
{%- if let Some(first) = team.first %}
{%- for statement in first.statements %}
        {{ statement }}
{%- endfor %}
{%- if leads %}
        {{ prefix }}_lead_t lead = { {{ first.value }}, {{ first.rank }} };
{%- else %}
        {{ scalar }} best = {{ first.value }};
        uint32_t {{ team.winner }} = {{ first.rank }};
{%- endif %}
{%- else if leads %}
        {{ prefix }}_lead_t lead = { -{{ lowest }}, {{ team.nobody }} };
{%- else %}
        {{ scalar }} best = -{{ lowest }};
        uint32_t {{ team.winner }} = {{ team.nobody }};
{%- endif %}
{%- for bid in team.eager %}
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}
{% include "c/fast_win.c" %}
{%- endfor %}
{%- for bid in team.lazy %}
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

{% for (ranks, jump) in team.ways %}        {% if !loop.last %}{% if !loop.first %}} else {% endif %}if ({% for rank in ranks %}{% if ranks.len() > 1 %}({% endif %}{{ team.winner }} == {{ rank }}{% if ranks.len() > 1 %}){% endif %}{% if !loop.last %} || {% endif %}{% endfor %}) {{ "{" }}{% else %}} else {{ "{" }}{% endif %}
{%- if let Some(vertex) = jump.vertex %}
            vertex = {{ vertex }}U;
{%- endif %}
            goto {{ jump.label }};
{% endfor %}        }
{%- else %}
{%- for (_, jump) in team.ways %}
{%- if let Some(vertex) = jump.vertex %}
        vertex = {{ vertex }}U;
{%- endif %}
        goto {{ jump.label }};
{%- endfor %}
{%- endif %}
    }
{% endfor %}
{% if leaves.is_empty() %}
decided:
    return {% if functions.len() > 1 %}vertex{% else %}(uint16_t)vertex{% endif %};
{%- else %}
{% for leaf in leaves %}
leaf_{{ leaf.label }}:
    {
{%- for statement in leaf.statements %}
        {{ statement }}
{%- endfor %}
{% for value in leaf.values %}
        {{ outputs[loop.index0].variable() }} = {{ value }};
{%- endfor %}
    }
{%- if !loop.last %}
    goto answered;
{% endif %}
{% endfor %}
{%- if leaves.len() > 1 %}
answered:
{%- endif %}
{%- for assignment in assignments %}
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
    return (uint16_t)vertex;
{%- else %}
    return vertex;
{%- endif %}
}
{{ over_functions }}
{% endif %}
