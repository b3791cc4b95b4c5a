//! The newest checkpoint of a run and the previous one, which is used if the newest is damaged.

use super::frame::{self, Fault};
use super::{RunFolder, Trainer};
use std::fs::{self, File};
use std::io::{ErrorKind, Read as _};
use std::path::Path;
use tpg_graph::error::{InputError, Place};
use tpg_graph::output::write_keeping_previous;

/// Name of the newest checkpoint.
pub(crate) const NEWEST: &str = "checkpoint";
/// Name of the checkpoint before it.
pub(crate) const PREVIOUS: &str = "checkpoint.previous";
/// Name under which a damaged checkpoint is set aside.
pub(crate) const DAMAGED: &str = "checkpoint.damaged";
/// Largest checkpoint, bytes: the largest replay buffer of the presets makes a sixth of it.
const LIMIT: u64 = 4 << 30;

impl RunFolder {
    /// Writes a checkpoint whole or not at all. The one that was the newest becomes the previous one.
    ///
    /// # Errors
    /// If it cannot be written; the newest checkpoint is then unchanged.
    pub fn save(&self, version: u32, content: Vec<u8>) -> Result<(), InputError> {
        let sealed = frame::seal(content, self.trainer, version);
        write_keeping_previous(&self.file(NEWEST), &self.file(PREVIOUS), &sealed)
    }

    /// Reads the newest checkpoint, or the previous one with a warning on stderr if the newest is damaged or missing;
    /// `None` if there is neither. `read` gets the name of the file and the content.
    ///
    /// A damaged checkpoint is set aside as [`DAMAGED`], so that it never takes the place of the previous one.
    ///
    /// # Errors
    /// If neither is whole, the one that is belongs to another trainer or version, or `read` refuses its content.
    pub fn load<T>(
        &self,
        version: u32,
        read: impl FnOnce(&str, &[u8]) -> Result<T, InputError>,
    ) -> Result<Option<T>, InputError> {
        let [newest, previous] = [NEWEST, PREVIOUS].map(|name| self.file(name));
        let reason = match content(&newest, self.trainer, version)? {
            Found::Whole(content) => return read(&newest.display().to_string(), &content).map(Some),
            Found::Nothing => None,
            Found::Damaged(reason) => Some(reason),
        };
        let content = match (content(&previous, self.trainer, version)?, reason) {
            (Found::Whole(content), _) => content,
            (Found::Nothing, None) => return Ok(None),
            (Found::Nothing, Some(reason)) => return Err(damaged(&newest, reason, "there is no previous one")),
            (Found::Damaged(reason), None) => return Err(damaged(&previous, reason, "there is no newer one")),
            (Found::Damaged(_), Some(reason)) => {
                return Err(damaged(&newest, reason, "the previous one is damaged, too"));
            }
        };
        let value = read(&previous.display().to_string(), &content)?;
        let found = reason.unwrap_or("missing");
        eprintln!("warning: {}: {found}; the run goes on from {PREVIOUS}", newest.display());
        if reason.is_some() {
            let aside = self.file(DAMAGED);
            fs::rename(&newest, &aside)
                .map_err(|error| InputError::io(&aside, &error, "a folder that can be written"))?;
        }
        Ok(Some(value))
    }
}

enum Found {
    Nothing,
    Whole(Vec<u8>),
    Damaged(&'static str),
}

fn content(path: &Path, trainer: Trainer, version: u32) -> Result<Found, InputError> {
    let io = |error: &std::io::Error| InputError::io(path, error, "a checkpoint that can be read");
    let refuse = |found: String, accepted: String| {
        Err(InputError::new(path.display().to_string(), Place::Whole, found, accepted))
    };
    let file = match File::open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Found::Nothing),
        file => file.map_err(|error| io(&error))?,
    };
    let mut bytes = Vec::new();
    file.take(LIMIT + 1).read_to_end(&mut bytes).map_err(|error| io(&error))?;
    if bytes.len() as u64 > LIMIT {
        return refuse(format!("more than {LIMIT} bytes"), format!("up to {LIMIT} bytes"));
    }
    let length = match frame::open(&bytes, trainer, version) {
        Ok(content) => content.len(),
        Err(Fault::Damaged(reason)) => return Ok(Found::Damaged(reason)),
        Err(Fault::Other(found)) => return refuse(found, format!("tpg-train {trainer}, checkpoint version {version}")),
    };
    bytes.truncate(length);
    Ok(Found::Whole(bytes))
}

fn damaged(path: &Path, reason: &str, beside: &str) -> InputError {
    let accepted = format!("a whole checkpoint ({beside}), or another --out");
    InputError::new(path.display().to_string(), Place::Whole, reason, accepted)
}

#[cfg(test)]
mod tests {
    use super::{DAMAGED, NEWEST, PREVIOUS, RunFolder, Trainer};
    use std::fs;
    use std::path::Path;
    use tpg_graph::error::InputError;

    fn opened(folder: &Path) -> RunFolder {
        RunFolder::open(folder, Trainer::Sac, true).expect("a folder")
    }

    fn text(_file: &str, content: &[u8]) -> Result<String, InputError> {
        Ok(String::from_utf8_lossy(content).into_owned())
    }

    fn load(folder: &RunFolder) -> Result<Option<String>, String> {
        folder.load(3, text).map_err(|error| error.to_string())
    }

    #[test]
    fn the_newest_is_read_or_the_previous_one_where_it_is_damaged_or_gone() {
        let place = tempfile::tempdir().expect("a temporary folder");
        let folder = opened(place.path());
        assert_eq!(load(&folder), Ok(None));
        for content in ["one", "two", "three"] {
            folder.save(3, content.into()).expect("written");
            assert_eq!(load(&folder).as_ref().map(Option::as_deref), Ok(Some(content)));
        }
        // As when a process was killed between the two renames.
        fs::remove_file(folder.file(NEWEST)).expect("removed");
        assert_eq!(load(&folder), Ok(Some("two".to_owned())));
        folder.save(3, "four".into()).expect("written");
        fs::write(folder.file(NEWEST), "fo").expect("written");
        assert_eq!(load(&folder), Ok(Some("two".to_owned())));
        assert_eq!(fs::read_to_string(folder.file(DAMAGED)).expect("set aside"), "fo");
        folder.save(3, "five".into()).expect("written");
        assert_eq!(load(&folder), Ok(Some("five".to_owned())));
        assert_eq!(fs::read_to_string(folder.file(PREVIOUS)).expect("kept").lines().next(), Some("two"));
    }

    #[test]
    fn two_damaged_checkpoints_are_refused_and_stay() {
        let place = tempfile::tempdir().expect("a temporary folder");
        let folder = opened(place.path());
        fs::write(folder.file(NEWEST), "{}").expect("written");
        assert!(load(&folder).expect_err("alone").contains("there is no previous one"));
        fs::write(folder.file(PREVIOUS), "{}").expect("written");
        let error = load(&folder).expect_err("both");
        assert!(error.contains("no checksum") && error.contains("damaged, too"), "{error}");
        fs::remove_file(folder.file(NEWEST)).expect("removed");
        assert!(load(&folder).expect_err("the previous alone").contains("checkpoint.previous"));
    }

    #[test]
    fn another_version_and_content_that_is_refused_are_errors_even_beside_a_previous_one() {
        let place = tempfile::tempdir().expect("a temporary folder");
        let folder = opened(place.path());
        folder.save(3, "one".into()).expect("written");
        folder.save(2, "two".into()).expect("written");
        let error = load(&folder).expect_err("another version");
        assert!(error.contains("checkpoint version 2; accepted: tpg-train sac, checkpoint version 3"), "{error}");
        folder.save(3, "three".into()).expect("written");
        let refuse = |file: &str, _: &[u8]| {
            Err::<(), _>(tpg_graph::error::InputError::new(file, tpg_graph::error::Place::Whole, "this", "that"))
        };
        assert!(folder.load(3, refuse).is_err());
        assert!(folder.file(NEWEST).exists() && !folder.file(DAMAGED).exists());
    }
}
