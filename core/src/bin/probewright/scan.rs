//! Digitizing in a run: the surface that is scanned, and the files for what is sent.

use crate::file;
use crate::file::Problem;
use probewright_core::app::{SurfaceChoice, put_surface};
use probewright_core::machine::setup::Setup;
use probewright_core::message::Message;
use probewright_core::scan::Sent;
use probewright_core::scan::text::{Form, piece};
use probewright_core::workpiece::free::EXAMPLES;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Points of a scan whose text is held in memory at once.
const PIECE: usize = 50_000;
/// Shares of red, green and blue in the brightness of a colour.
const BRIGHTNESS: [f64; 3] = [0.299, 0.587, 0.114];

/// Surface and files of a scan.
#[derive(clap::Args)]
pub struct Files {
    #[arg(long, value_name = "FILE", requires = "setup")]
    surface: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    scan_nc: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    scan_xyz: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    scan_surface: Option<PathBuf>,
}

impl Files {
    /// Puts the surface that is named into the setup.
    pub fn put_surface(&self, setup: &mut Setup) -> Result<(), Problem> {
        let Some(path) = &self.surface else { return Ok(()) };
        let (name, bytes) = surface(path)?;
        match put_surface(setup, &name, &bytes).map_err(|error| file::wrong_file(path, error.message))? {
            true => Ok(()),
            false => Err(file::wrong_file(path, Message::new("terminal-surface"))),
        }
    }

    /// Writes the files that are named; several scans stand one behind the other.
    pub fn write(&self, scans: &[Sent]) -> Result<(), Problem> {
        let files =
            [(&self.scan_nc, Form::Program), (&self.scan_xyz, Form::Points), (&self.scan_surface, Form::Surface)];
        for (path, form) in files {
            if let Some(path) = path {
                file::write(path, scans.iter().flat_map(|scan| text(scan, form)))?;
            }
        }
        Ok(())
    }
}

/// The text of a scan in pieces.
fn text(Sent { cloud, layout }: &Sent, form: Form) -> impl Iterator<Item = String> {
    let pieces = (0..cloud.points().len()).step_by(PIECE);
    pieces.map(move |from| piece(cloud, layout, form, from..from + PIECE))
}

/// What is named: one of ours, an STL file, else a picture.
fn surface(path: &Path) -> Result<(SurfaceChoice, Vec<u8>), Problem> {
    let known = EXAMPLES.iter().find(|(name, _)| path == Path::new(name));
    if let Some((name, _)) = known {
        return Ok((SurfaceChoice::Example((*name).to_owned()), Vec::new()));
    }
    let bytes = file::bytes(path)?;
    let ending = path.extension().and_then(OsStr::to_str).unwrap_or_default();
    if ending.eq_ignore_ascii_case("stl") {
        return Ok((SurfaceChoice::Stl, bytes));
    }
    let (columns, greys) = greys(&bytes).map_err(|_| file::wrong_file(path, Message::new("terminal-picture")))?;
    Ok((SurfaceChoice::Picture(columns), greys))
}

/// Pixels a row and grey values of a PNG picture; what is clear lies on white.
fn greys(file: &[u8]) -> Result<(usize, Vec<u8>), png::DecodingError> {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame = reader.next_frame(&mut pixels)?;
    let grey = |pixel: &[u8]| {
        let (colour, alpha) = match pixel {
            [grey] => ([*grey; 3], u8::MAX),
            [grey, alpha] => ([*grey; 3], *alpha),
            [red, green, blue] => ([*red, *green, *blue], u8::MAX),
            [red, green, blue, alpha, ..] => ([*red, *green, *blue], *alpha),
            [] => ([0; 3], 0),
        };
        let bright = colour.iter().zip(BRIGHTNESS);
        let bright: f64 = bright.map(|(value, share)| f64::from(*value) * share).sum();
        let cover = f64::from(alpha) / 255.0;
        (bright * cover + 255.0 * (1.0 - cover)).round() as u8
    };
    let rows = pixels.chunks_exact(frame.color_type.samples());
    let count = frame.width as usize * frame.height as usize;
    Ok((frame.width as usize, rows.take(count).map(grey).collect()))
}
