
{%- if leads %}
        {{ prefix }}_take{% if !bid.ascending %}_at{% endif %}(&lead, {{ bid.value }}, {{ bid.rank }});
{%- else %}
        if ({{ bid.wins }}) {
{%- if !bid.last %}
            best = {{ bid.value }};
{%- endif %}
            {{ team.view.winner }} = {{ bid.rank }};
        }
{%- endif %}
