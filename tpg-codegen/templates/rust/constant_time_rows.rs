        // Some teams a row. An action leads to itself, and so does what fills the rows up to a power of two: it is never come to.
        let next: [[{{ vertex }}; {{ row }}]; {{ rows.len() }}] = {{ layout::array(rows, 8) }};
        // The longest walk decides {{ depth }} times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0][0];
{%- for _ in 1..depth %}
        let vertex = next[((vertex / {{ row }}) & {{ rows.len() - 1 }}) as usize][(vertex % {{ row }}) as usize];
{%- endfor %}
        {{ answer }}
