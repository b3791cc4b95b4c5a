{{ decided }}
{% if !only %}
        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [{{ vertex }}; {{ size }}] = {{ layout::array(next, 8) }};
        // The longest walk decides {{ depth }} times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
{%- for _ in 1..depth %}
        let vertex = next[(vertex & {{ size - 1 }}) as usize];
{%- endfor %}
{%- endif %}
        {{ answer }}
