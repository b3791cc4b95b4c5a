//! Decides for states from standard input: see tpg-codegen's verify::process.

// By its path: the file may be called like a keyword.
#[path = "{{ module }}.rs"]
mod policy;

use std::io::{self, Read, Write};
{% if outputs == 0 -%}
use tpg_runtime::policy::{ActionId, Policy};
{%- else if memory == 0 -%}
use tpg_runtime::policy::Policy;
{%- endif %}

const LENGTH: usize = {{ state_length }};
const WIDTH: usize = size_of::<{{ scalar }}>();

fn main() -> io::Result<()> {
    let mut input = io::stdin().lock();
    let mut output = io::stdout().lock();
    let mut head = [0; 4];
    while input.read_exact(&mut head).is_ok() {
        let count = u32::from_le_bytes(head) as usize;
        let mut bytes = vec![0; count * LENGTH * WIDTH];
        input.read_exact(&mut bytes)?;
        let mut actions = Vec::with_capacity(count * 2);
        for values in bytes.chunks_exact(LENGTH * WIDTH) {
            let mut state = [0.0; LENGTH];
            for (slot, value) in state.iter_mut().zip(values.chunks_exact(WIDTH)) {
                *slot = {{ scalar }}::from_ne_bytes(value.try_into().unwrap());
            }
{%- if outputs == 0 %}
            let ActionId(action) = policy::{{ name }}.decide(&state);
            actions.extend(action.to_ne_bytes());
{%- else %}
{%- if memory == 0 %}
            actions.extend(policy::{{ name }}.decide(&state).into_iter().flat_map({{ scalar }}::to_ne_bytes));
{%- else %}
            let (state, memory) = state.split_at(LENGTH - {{ memory }});
            let mut memory = memory.try_into().unwrap();
            let values = policy::{{ name }}.infer(state.try_into().unwrap(), &mut memory);
            actions.extend(values.into_iter().chain(memory).flat_map({{ scalar }}::to_ne_bytes));
{%- endif %}
{%- endif %}
        }
        output.write_all(&actions)?;
        output.flush()?;
    }
    Ok(())
}
