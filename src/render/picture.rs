//! A picture, and its PNG.

use glam::DVec3;

/// Rows of pixels from the top left; red, green and blue from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    size: [u32; 2],
    pixels: Vec<DVec3>,
}

impl Picture {
    /// A black one, of `size` (columns, rows).
    pub fn new(size: [u32; 2]) -> Self {
        Picture { size, pixels: vec![DVec3::ZERO; size[0] as usize * size[1] as usize] }
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Place of a pixel in the list.
    pub fn index(&self, column: u32, row: u32) -> usize {
        row as usize * self.size[0] as usize + column as usize
    }

    /// The pixels, by rows from the top left.
    pub fn pixels(&self) -> &[DVec3] {
        &self.pixels
    }

    /// The same pixels, to be painted.
    pub fn pixels_mut(&mut self) -> &mut [DVec3] {
        &mut self.pixels
    }

    /// As PNG: eight bits a colour, each rounded to the nearest. The same picture gives the same bytes.
    ///
    /// # Errors
    /// For a side that PNG cannot hold: 0, or more than 2^31 - 1.
    pub fn png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let [columns, rows] = self.size;
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, columns, rows);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        let eighth = |share: f64| (share.clamp(0.0, 1.0) * 255.0).round() as u8;
        let data: Vec<u8> =
            self.pixels.iter().flat_map(|pixel| pixel.to_array().map(eighth)).collect();
        writer.write_image_data(&data)?;
        writer.finish()?;
        Ok(bytes)
    }
}
