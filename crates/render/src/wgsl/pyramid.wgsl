// Greatest thickness over blocks of cells, a level a dispatch: level 0 over the four corners of each cell, each next one over two by two
// blocks of the one before. Where a side is odd the last block is narrower; blocks never reach over the period's edge.
struct Level {
    source: u32,
    source_side: u32,
    start: u32,
    side: u32,
}

@group(0) @binding(0) var<uniform> level: Level;
@group(0) @binding(1) var<storage, read_write> heights: array<f32>;

fn at(x: u32, y: u32) -> f32 {
    return heights[level.source + y * level.source_side + x];
}

@compute @workgroup_size(8, 8)
fn pyramid_cells(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= level.side || id.y >= level.side) {
        return;
    }
    let east = (id.x + 1u) % level.source_side;
    let north = (id.y + 1u) % level.source_side;
    heights[level.start + id.y * level.side + id.x] =
        max(max(at(id.x, id.y), at(east, id.y)), max(at(id.x, north), at(east, north)));
}

@compute @workgroup_size(8, 8)
fn pyramid_blocks(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= level.side || id.y >= level.side) {
        return;
    }
    let west = 2u * id.x;
    let south = 2u * id.y;
    let east = min(west + 1u, level.source_side - 1u);
    let north = min(south + 1u, level.source_side - 1u);
    heights[level.start + id.y * level.side + id.x] =
        max(max(at(west, south), at(east, south)), max(at(west, north), at(east, north)));
}
