//! Rays that the user wrote down.

use super::reach;
use crate::check::read::{ReadError, Records, Schema};
use crate::scene::bounds::Bounds;
use crate::workload::Ray;
use glam::Vec3;
use std::fs::File;
use std::io::{BufRead, BufReader};

/// Origin, direction, and the range of t, which may be missing.
const SCHEMA: Schema =
    Schema { names: &["ox", "oy", "oz", "dx", "dy", "dz", "tmin", "tmax"], required: 6 };
/// The range where none is given.
const RANGE: [f32; 2] = [0.0, f32::MAX];
const T_MIN: usize = 6;
const T_MAX: usize = 7;

/// The rays of a file of CSV with a header, or of JSON lines.
pub(super) fn load(path: &str, bounds: &Bounds) -> Result<Vec<Ray>, ReadError> {
    let failed = |source| ReadError::Io { file: path.to_owned(), source };
    read(BufReader::new(File::open(path).map_err(failed)?), path, bounds)
}

/// Numbers are rounded to f32, an infinite end of the range to the largest number.
pub(super) fn read(
    input: impl BufRead,
    file: &str,
    bounds: &Bounds,
) -> Result<Vec<Ray>, ReadError> {
    let mut records = Records::new(input, file, SCHEMA);
    let mut rays = Vec::new();
    while records.advance()? {
        rays.push(ray(&records, bounds)?);
    }
    if rays.is_empty() {
        let message = "no ray; allowed: CSV with a header and at least one row, or JSON lines";
        return Err(records.whole(message.into()));
    }
    Ok(rays)
}

fn ray<R: BufRead>(records: &Records<R>, bounds: &Bounds) -> Result<Ray, ReadError> {
    let mut numbers = [0.0; 6];
    for (index, number) in numbers.iter_mut().enumerate() {
        let read = records.text(index).and_then(|text| text.parse::<f32>().ok());
        *number = read.filter(|x| x.is_finite()).ok_or_else(|| {
            records.bad(index, "a number that f32 holds, neither nan nor infinite")
        })?;
    }
    let bound = |index: usize| match records.text(index).map(str::parse::<f32>) {
        None => Ok(RANGE[index - T_MIN]),
        Some(Ok(x)) if !x.is_nan() => Ok(x.clamp(f32::MIN, f32::MAX)),
        Some(_) => Err(records.bad(index, "a number, inf or -inf")),
    };
    let (t_min, t_max) = (bound(T_MIN)?, bound(T_MAX)?);
    if t_min > t_max {
        return Err(records.bad(T_MAX, &format!("at least tmin, which is {t_min}")));
    }
    let [ox, oy, oz, dx, dy, dz] = numbers;
    let (origin, direction) = (Vec3::new(ox, oy, oz), Vec3::new(dx, dy, dz));
    // The segment form ends where the range does, or behind the mesh.
    let length = direction.as_dvec3().length().max(f64::MIN_POSITIVE);
    let behind = f64::from(reach(origin, bounds)) / length;
    let end = origin.as_dvec3() + direction.as_dvec3() * behind.min(f64::from(t_max));
    let end = end.as_vec3().clamp(Vec3::MIN, Vec3::MAX);
    Ok(Ray { origin, direction, end, t_min, t_max })
}
