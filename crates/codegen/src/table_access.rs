//! How each language reaches a table: the only text that is written per language.

use crate::Target;

/// A table of rows that the host binds, or that the text carries where long constant arrays are no trouble.
pub(crate) struct Table {
    /// `stratiform_x`: the table is `stratiform_x_table`, its reader `stratiform_x_texel`.
    pub prefix: &'static str,
    /// How it is used in MSL.
    pub owner: &'static str,
    /// What it holds.
    pub content: &'static str,
    /// What a texture of it must be like.
    pub texture: String,
    pub binding: u32,
    pub columns: usize,
    /// Row by row.
    pub values: Vec<String>,
}

impl Table {
    /// The table and the function that reads it.
    pub fn access(&self, target: Target) -> String {
        let Self { prefix, binding, columns, .. } = self;
        let bound = "// The host binds the table here; change the binding to suit.\n";
        let indexed = format!("{prefix}_table[row * {columns}u + index]");
        match target {
            Target::Wgsl => {
                format!(
                    "{bound}@group(0) @binding({binding}) var<storage, read> {prefix}_table: array<f32>;\n\n"
                ) + &reader(&format!("fn {prefix}_texel(row: u32, index: u32) -> f32"), &indexed)
            }
            Target::Glsl450 => {
                let block = self.block();
                format!(
                    "{bound}layout(std430, binding = {binding}) readonly buffer {block} {{\n    float {prefix}_table[];\n}};\n\n"
                ) + &reader(&format!("float {prefix}_texel(uint row, uint index)"), &indexed)
            }
            Target::Glsl330 | Target::Glsl300Es => self.texture(),
            Target::Hlsl => {
                format!("{bound}StructuredBuffer<float> {prefix}_table : register(t{binding});\n\n")
                    + &reader(&format!("float {prefix}_texel(uint row, uint index)"), &indexed)
            }
            Target::Msl => {
                format!("// The table: {}\nconst device float* {prefix}_table;\n\n", self.owner)
                    + &reader(&format!("float {prefix}_texel(uint row, uint index) const"), &indexed)
            }
            Target::C => {
                let (count, numbers) = (self.values.len(), self.numbers("f"));
                format!("static const float {prefix}_table[{count}] = {{\n{numbers}}};\n\n")
                    + &reader(
                        &format!("static inline float {prefix}_texel(uint32_t row, uint32_t index)"),
                        &indexed,
                    )
            }
            Target::Rust => self.rust(),
            Target::Spirv => String::new(),
        }
    }

    /// `StratiformXTable`.
    fn block(&self) -> String {
        let word = |word: &str| word[..1].to_uppercase() + &word[1..];
        self.prefix.split('_').map(word).collect::<String>() + "Table"
    }

    fn texture(&self) -> String {
        let Self { prefix, columns, texture, .. } = self;
        let value = format!("texelFetch({prefix}_table, ivec2(int(index), int(row)), 0).r");
        format!(
            "// The host binds the table here: a float texture {columns} wide. {texture}\nuniform highp sampler2D {prefix}_table;\n\n"
        ) + &reader(&format!("float {prefix}_texel(uint row, uint index)"), &value)
    }

    fn rust(&self) -> String {
        let Self { prefix, columns, content, .. } = self;
        let (name, count, numbers) = (prefix.to_uppercase(), self.values.len(), self.numbers(""));
        format!("/// {content}.\npub static {name}_TABLE: [f32; {count}] = [\n{numbers}];\n\n")
            + &format!(
                "/{READ}pub fn {prefix}_texel(row: u32, index: u32) -> f32 {{\n    {name}_TABLE[(row * {columns} + index) as usize]\n}}\n\n"
            )
    }

    fn numbers(&self, suffix: &str) -> String {
        let line = |line: &[String]| {
            let numbers: Vec<_> = line.iter().map(|number| format!("{number}{suffix},")).collect();
            format!("    {}\n", numbers.join(" "))
        };
        self.values.chunks(8).map(line).collect()
    }
}

const READ: &str = "// Value `index` of row `row` of the table.\n";

fn reader(head: &str, value: &str) -> String {
    format!("{READ}{head} {{\n    return {value};\n}}\n\n")
}
