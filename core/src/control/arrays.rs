//! Elements of arrays, in the order in which `SET` and `REP` fill them: the last index counts first.

use super::{Control, gud};

/// R parameters are one array: `R10` is its element 10.
const R_PARAMETERS: [usize; 1] = [1000];

/// Sizes of the user data or R parameters with this name (with or without index); none: no array of the control.
pub fn sizes(name: &str) -> Option<&'static [usize]> {
    let (stem, _) = with_parameters(name)?;
    if stem == "R" {
        return Some(&R_PARAMETERS);
    }
    gud::find(stem).map(|gud| gud.sizes).filter(|sizes| !sizes.is_empty())
}

/// Names of the elements from this one (without index: the first) to the end of its array; none: it does not fit.
pub fn elements_from(name: &str, sizes: &[usize]) -> Vec<String> {
    following(name, sizes).collect()
}

/// The same, each when it is asked for.
pub fn following<'a>(name: &'a str, sizes: &'a [usize]) -> impl Iterator<Item = String> + 'a {
    let (stem, index) = with_parameters(name).unwrap_or_default();
    let total: usize = sizes.iter().product();
    let first = match index.len() {
        0 if !stem.is_empty() => Some(0),
        n if n == sizes.len() => place(&index, sizes),
        _ => None,
    };
    first.map_or(total..total, |first| first..total).map(move |at| element(stem, at, sizes))
}

/// Elements that `REP` fills from this one on; none: it is no array of the control.
pub fn repeated(control: &Control, name: &str) -> Option<Vec<String>> {
    let mut sizes = sizes(name)?.to_vec();
    let (stem, _) = with_parameters(name)?;
    if let Some(gud) = gud::find(stem).filter(|gud| !gud.counted.is_empty()) {
        let largest = sizes.first_mut()?;
        *largest = (control.number(gud.counted) as usize).min(*largest);
    }
    Some(elements_from(name, &sizes))
}

/// A name without its index.
pub fn stem(name: &str) -> &str {
    let end = name.bytes().position(|byte| byte == b'[');
    end.map_or(name, |end| name.split_at(end).0)
}

/// Stem and index: `_WP[0,1]` is `_WP` and 0, 1.
pub fn split(name: &str) -> Option<(&str, Vec<usize>)> {
    let Some((stem, rest)) = name.split_once('[') else { return Some((name, Vec::new())) };
    let index: Result<Vec<usize>, _> = rest.strip_suffix(']')?.split(',').map(str::parse).collect();
    Some((stem, index.ok()?))
}

/// Stem and index; `R10` is `R` and 10.
fn with_parameters(name: &str) -> Option<(&str, Vec<usize>)> {
    match name.strip_prefix('R').and_then(|digits| digits.parse().ok()) {
        Some(number) => Some(("R", vec![number])),
        None => split(name),
    }
}

/// How many elements stand before this one; none: the index lies outside.
pub fn place(index: &[usize], sizes: &[usize]) -> Option<usize> {
    index.iter().zip(sizes).try_fold(0, |at, (i, size)| (i < size).then_some(at * size + i))
}

pub(super) fn spelled(stem: &str, at: &[usize]) -> String {
    let index: Vec<String> = at.iter().map(usize::to_string).collect();
    format!("{stem}[{}]", index.join(","))
}

fn element(stem: &str, mut at: usize, sizes: &[usize]) -> String {
    if stem == "R" {
        return format!("R{at}");
    }
    let mut index = vec![0; sizes.len()];
    for (i, size) in index.iter_mut().zip(sizes).rev() {
        *i = at % size;
        at /= size;
    }
    spelled(stem, &index)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;

    #[test]
    fn the_last_index_counts_first() {
        // oracle: hand
        assert_eq!(elements_from("_X[0,1]", &[2, 3]), ["_X[0,1]", "_X[0,2]", "_X[1,0]", "_X[1,1]", "_X[1,2]"]);
        assert_eq!(elements_from("_X", &[2]), ["_X[0]", "_X[1]"]);
        assert_eq!(elements_from("R998", sizes("R998").unwrap()), ["R998", "R999"]);
        assert!(elements_from("_X[2]", &[2]).is_empty());
        assert!(elements_from("_X[1]", &[2, 3]).is_empty());
    }

    #[test]
    fn only_arrays_have_elements() {
        let control = delivery(Dialect::Sinumerik);
        // oracle: manual B:16655 (nine set values), B:13442 (three probes as delivered, eleven data each)
        assert_eq!(repeated(&control, "_SETV").unwrap().len(), 9);
        assert_eq!(repeated(&control, "_WP[1,5]").unwrap().len(), 6 + 11);
        assert_eq!(repeated(&control, "_SETVAL"), None);
        assert_eq!(repeated(&control, "NOTHING[0]"), None);
    }
}
