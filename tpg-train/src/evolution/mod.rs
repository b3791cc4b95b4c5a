//! Evolution of tangled program graphs: settings, stages of a run, genome, mutation, selection, and what a run writes.

mod budget;
mod checkpoint;
mod children;
mod cma;
pub(crate) mod command;
pub(crate) mod config;
pub(crate) mod export;
pub(crate) mod generation;
mod genome;
mod linear;
mod mirror;
mod mutate_leaf;
mod mutate_program;
mod mutate_team;
mod normalise;
mod params;
mod population;
pub(crate) mod presets;
mod products;
mod random_search;
pub(crate) mod record;
mod refine;
pub(crate) mod run;
mod scales;
mod search;
mod select;
pub(crate) mod stage;
pub(crate) mod state;
mod target;
mod thin;
mod validate;
mod vocabulary;

#[cfg(test)]
mod tests {
    use super::config::EvolutionConfig;
    use super::stage::Context;
    use super::vocabulary::Vocabulary;
    use tpg_engine::Preference;

    /// Returns what stages know of a run, for so many actions; 0 with outputs.
    pub(super) fn context<'a>(
        config: &'a EvolutionConfig,
        vocabulary: &'a Vocabulary,
        actions: u16,
        opposites: &'a [Option<u16>],
    ) -> Context<'a> {
        Context {
            config,
            vocabulary,
            actions,
            opposites,
            max_lines: config.program.max_program_size,
            preference: Preference::Score,
            line_price: 0.0,
            left: 1.0,
            samples: 16,
            time_limit: 1000,
        }
    }
}
