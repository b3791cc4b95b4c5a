//! Policies in one program; its argument says which one decides for states from standard input: see tpg-codegen's
//! verify::process.
{% for policy in policies %}
// By its path: the file may be called like a keyword.
#[path = "{{ policy.prefix }}.rs"]
mod policy_{{ loop.index0 }};
{%- endfor %}

use std::io::{self, Read, Write};
use tpg_runtime::policy::{ActionId, Policy};

fn serve<const N: usize, S: Copy + Default, B: IntoIterator<Item = u8>>(
    number: fn(f64) -> S,
    decide: impl Fn(&[S; N]) -> B,
) -> io::Result<()> {
    let mut input = io::stdin().lock();
    let mut output = io::stdout().lock();
    let mut head = [0; 4];
    while input.read_exact(&mut head).is_ok() {
        let count = u32::from_le_bytes(head) as usize;
        let mut bytes = vec![0; count * N * 8];
        input.read_exact(&mut bytes)?;
        let mut actions = Vec::with_capacity(count * 2);
        for values in bytes.chunks_exact(N * 8) {
            let mut state = [S::default(); N];
            for (slot, value) in state.iter_mut().zip(values.chunks_exact(8)) {
                *slot = number(f64::from_ne_bytes(value.try_into().unwrap()));
            }
            actions.extend(decide(&state));
        }
        output.write_all(&actions)?;
        output.flush()?;
    }
    Ok(())
}

fn main() -> io::Result<()> {
    match std::env::args().nth(1).and_then(|number| number.parse::<usize>().ok()) {
{%- for policy in policies %}
        Some({{ loop.index0 }}) => serve(|value| value as {{ policy.kind }}, |state: &[{{ policy.kind }}; {{ policy.state_length }}]| {
{%- if policy.outputs == 0 %}
            let ActionId(action) = policy_{{ loop.index0 }}::{{ policy.name }}.decide(state);
            action.to_ne_bytes()
{%- else if policy.memory.is_empty() %}
            let values = policy_{{ loop.index0 }}::{{ policy.name }}.decide(state);
            values.into_iter().flat_map(|value| f64::from(value).to_ne_bytes())
{%- else %}
            let (seen, memory) = state.split_at({{ policy.state_length - policy.memory.len() }});
            let mut memory = memory.try_into().unwrap();
            let values = policy_{{ loop.index0 }}::{{ policy.name }}.infer(seen.try_into().unwrap(), &mut memory);
            values.into_iter().chain(memory).flat_map(|value| f64::from(value).to_ne_bytes())
{%- endif %}
        }),
{%- if let Some([bytes, row]) = policy.image %}
        Some({{ loop.index0 + policies.len() }}) => serve(|value| value as u8, |image: &[u8; {{ bytes }}]| {
            let mut state = [Default::default(); {{ policy.state_length - policy.memory.len() }}];
            assert!(policy_{{ loop.index0 }}::{{ policy.name }}.look(image, {{ row }}, &mut state));
            state.into_iter().flat_map(|value| f64::from(value).to_ne_bytes())
        }),
{%- endif %}
{%- endfor %}
        _ => Err(io::Error::other("no such policy")),
    }
}
