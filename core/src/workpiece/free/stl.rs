//! STL files, binary and as text. Both hold single triangles; the normals they give are not looked at.

use super::{check_count, numbers, refused};
use crate::refused::Refused;

/// Bytes before the triangles of a binary file: header and count.
const HEAD: usize = 84;
/// Bytes of a triangle: normal, three corners, attribute.
const TRIANGLE: usize = 50;

/// The triangles of a file, in its own coordinates, taken as mm.
pub(crate) fn triangles(file: &[u8]) -> Result<Vec<[[f64; 3]; 3]>, Refused> {
    let triangles = match count(file) {
        Some(count) => {
            check_count(count)?;
            binary(file)
        }
        None => text(file)?,
    };
    check_count(triangles.len())?;
    numbers(triangles.as_flattened().as_flattened())?;
    Ok(triangles)
}

/// How many triangles a binary file has: its length follows from it. A binary file may begin with "solid" like a text.
fn count(file: &[u8]) -> Option<usize> {
    let bytes = file.get(HEAD - 4..HEAD)?.first_chunk::<4>()?;
    let count = u32::from_le_bytes(*bytes) as usize;
    let length = count.checked_mul(TRIANGLE)?.checked_add(HEAD)?;
    (length == file.len()).then_some(count)
}

fn binary(file: &[u8]) -> Vec<[[f64; 3]; 3]> {
    let triangles = file.get(HEAD..).unwrap_or_default().chunks_exact(TRIANGLE);
    let number = |bytes: &[u8], index: usize| {
        let bytes = bytes.get(12 + 4 * index..).and_then(<[u8]>::first_chunk);
        bytes.map_or(f64::NAN, |bytes| f64::from(f32::from_le_bytes(*bytes)))
    };
    let corner = |bytes: &[u8], first: usize| [0, 1, 2].map(|axis| number(bytes, first + axis));
    triangles.map(|bytes| [0, 3, 6].map(|first| corner(bytes, first))).collect()
}

fn text(file: &[u8]) -> Result<Vec<[[f64; 3]; 3]>, Refused> {
    let no_stl = |why: &str| refused("surface-stl").text("why", why);
    let text = std::str::from_utf8(file).map_err(|_| no_stl("stl-neither"))?;
    let mut words = text.split_ascii_whitespace();
    if !words.next().is_some_and(|word| word.eq_ignore_ascii_case("solid")) {
        return Err(no_stl("stl-begin"));
    }
    let mut corners = Vec::new();
    while let Some(word) = words.next() {
        if !word.eq_ignore_ascii_case("vertex") {
            continue;
        }
        let mut number = || words.next()?.parse::<f64>().ok();
        let (Some(x), Some(y), Some(z)) = (number(), number(), number()) else {
            return Err(no_stl("stl-vertex"));
        };
        corners.push([x, y, z]);
    }
    let (triangles, rest) = corners.as_chunks::<3>();
    if rest.is_empty() { Ok(triangles.to_vec()) } else { Err(no_stl("stl-triangle")) }
}
