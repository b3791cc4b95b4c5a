//! {{ it.title }}.
#![no_std]

mod {{ it.name }};

pub use tpg_runtime::policy::{% if it.outputs.is_empty() %}{ActionId, Policy}{% else %}Policy{% endif %};
pub use {{ it.name }}::{{ it.camel }};
