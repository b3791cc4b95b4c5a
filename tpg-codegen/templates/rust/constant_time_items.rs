{% for function in functions %}
/// Where some of the teams lead. What teams of two functions need, both compute.
#[inline(never)]
fn teams_{{ loop.index0 }}(s: &[{{ scalar }}; {{ state_length }}]) -> [{{ vertex }}; {{ row }}] {
{{ function.decided }}
    {{ layout::array(function.next, 4) }}
}
{% endfor %}
/// Vertices that lead to themselves.
#[inline(never)]
fn themselves(first: {{ vertex }}) -> [{{ vertex }}; {{ row }}] {
    {{ layout::array(themselves, 4) }}
}
