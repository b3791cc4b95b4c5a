//! Problems as policies are tested on them: by what the policies say about their training, on tasks from files.

use crate::arm::motors::{MotorsConfig, MotorsTask, Rules};
use crate::arm::planner::{self, CONTROLLERS};
use crate::arm::{ArmDescription, ArmTask, targets};
use crate::dodge;
use crate::registry::{PolicyKind, Problem, ProblemName, ProblemSettings};
use serde::Deserialize;
use std::path::Path;
use tpg_engine::{AnyTask, EpisodeResult};
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};

impl Problem {
    /// Returns a problem as policies are tested on it without a configuration: the arm is that of the graph's training.
    ///
    /// # Errors
    /// If the graph's provenance describes an arm that cannot be; `file` is the graph's.
    pub fn tested(name: ProblemName, graph: Option<(&str, &Graph)>) -> Result<Self, InputError> {
        let mut problem = Self::new(name).for_tests();
        if let ProblemSettings::Arm(config) = &mut problem.settings {
            config.coef_reward_multiplication = 0.01;
            config.arm = graph.map(|(file, graph)| arm_of(file, graph)).transpose()?.flatten();
        }
        Ok(problem)
    }

    /// Returns the problem as policies are tested on it: they can read and do whatever it knows.
    #[must_use]
    pub fn for_tests(mut self) -> Self {
        if let ProblemSettings::Arm(config) = &mut self.settings {
            config.tests = true;
        }
        self
    }

    /// Returns the problem for a network with these settings, as its file says them. With `rules` the network's rules of tests
    /// hold; without a graph beside it, it brings its whole problem.
    ///
    /// # Errors
    /// If the settings are not the problem's, or the network is for another arm; `file` is the network's.
    pub fn joined(mut self, file: &str, network: &toml::Table, rules: bool, graph: bool) -> Result<Self, InputError> {
        let start = self.start();
        let ProblemSettings::Arm(config) = &mut self.settings else {
            // Integers do not name their problem.
            let is_whole = rules && !graph && network.contains_key("name");
            return if is_whole { Self::from_table(file, network, PolicyKind::Graph) } else { Ok(self) };
        };
        let mut table = network.clone();
        // Integers do not name their problem, and no arm.
        let names_arm = table.remove("name").is_some();
        let motors: MotorsConfig = toml::Value::Table(table).try_into().map_err(|error: toml::de::Error| {
            InputError::new(file, Place::Path("problem".to_owned()), error.message(), "a network of the arm's motors")
        })?;
        if rules && names_arm {
            let tests = motors.tests(start);
            (config.tolerance, config.backlash) = (tests.tolerance, tests.backlash);
            if !graph {
                config.arm = motors.arm.clone();
            }
        }
        if names_arm && motors.arm() != config.arm() {
            let accepted = "one for the arm of the configuration, or of the graph";
            return Err(InputError::new(file, Place::Whole, "a network for another arm", accepted));
        }
        config.network = Some(Box::new(MotorsConfig { arm: config.arm.clone(), ..motors }));
        Ok(self)
    }

    /// Tests for the same settings, whatever network takes part: policies do the same episodes under the same rules.
    pub fn has_same_episodes(&self, other: &Self) -> bool {
        let mut pair = [self, other].map(Clone::clone);
        for problem in &mut pair {
            if let ProblemSettings::Arm(config) = &mut problem.settings {
                config.network = None;
            }
        }
        pair[0] == pair[1]
    }

    /// Reads tasks from a CSV file, for a network alone or for anything else.
    ///
    /// # Errors
    /// If the file cannot be read, or the problem has no such files.
    pub fn read_tasks(&self, path: &Path, network_alone: bool) -> Result<Vec<AnyTask>, InputError> {
        match &self.settings {
            ProblemSettings::Arm(config) => {
                let tasks = targets::read_csv(&config.arm(), path)?.into_iter();
                let rules = Rules::Test(self.start());
                let motors = |task: targets::Task| MotorsTask { start: task.start.0, target: task.target, rules };
                Ok(match network_alone {
                    true => tasks.map(|task| AnyTask::new(motors(task))).collect(),
                    false => tasks.map(|task| AnyTask::new(ArmTask::from(task))).collect(),
                })
            }
            ProblemSettings::Dodge(_) => {
                Ok(dodge::file::read_csv(path)?.into_iter().map(|row| AnyTask::new(row.scene)).collect())
            }
            _ => {
                let found = format!("tasks from a file for {}", self.name().name());
                Err(InputError::new(path.display().to_string(), Place::Whole, found, "fs, rs or dodge"))
            }
        }
    }

    /// Returns true if policies of one problem can act in the other.
    pub fn share_policies(one: &str, other: &str) -> bool {
        let is_arm = |name: &str| ProblemName::from_name(name).is_some_and(|name| name.start().is_some());
        one == other || (is_arm(one) && is_arm(other))
    }

    /// Returns the names of the controllers that learn nothing, if the problem has some.
    pub fn controllers(&self) -> &'static [&'static str] {
        if matches!(self.settings, ProblemSettings::Arm(_)) { &CONTROLLERS } else { &[] }
    }

    /// Lets a controller do tasks; `None` if the problem has none of that name.
    pub fn controlled(&self, name: &str, tasks: &[AnyTask]) -> Option<Vec<EpisodeResult>> {
        let ProblemSettings::Arm(config) = &self.settings else { return None };
        let tasks: Vec<targets::Task> =
            tasks.iter().filter_map(|task| task.typed::<ArmTask>().map(Into::into)).collect();
        planner::controlled(name, &config.arm(), &config.problem(self.start()), &tasks)
    }
}

/// Returns the arm that a graph was trained for, as its provenance says; `None` where that says nothing.
fn arm_of(file: &str, graph: &Graph) -> Result<Option<ArmDescription>, InputError> {
    let config = graph.provenance().config.as_ref();
    let Some(text) = config.and_then(|config| config.get("problem")?.get("arm").or(config.get("arm"))) else {
        return Ok(None);
    };
    let refuse = |found: String| {
        let place = Place::Path("$.provenance.config.problem.arm".to_owned());
        InputError::new(file, place, found, "an arm as `tpg-train config widowx` prints, or none")
    };
    let arm = ArmDescription::deserialize(text).map_err(|error| refuse(error.to_string()))?;
    arm.check().map_err(|finding| refuse(format!("{} = {}", finding.key, finding.found)))?;
    Ok(Some(arm))
}
