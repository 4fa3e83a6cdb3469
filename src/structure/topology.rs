//! Who is whose child: a hierarchy before its volumes are known. Every builder makes one.

/// A tree over triangles.
#[derive(Clone, Debug, Default)]
pub struct Topology {
    nodes: Vec<Branch>,
    root: usize,
}

/// A node of a tree.
#[derive(Clone, Debug)]
pub enum Branch {
    /// Triangles.
    Leaf(Vec<u32>),
    /// Nodes.
    Inner(Vec<usize>),
}

impl Topology {
    /// Of those nodes, of which each but the root is the child of exactly one other.
    pub fn new(nodes: Vec<Branch>, root: usize) -> Self {
        Topology { nodes, root }
    }

    /// The node at the top; `None` of nothing.
    pub fn root(&self) -> Option<usize> {
        (!self.nodes.is_empty()).then_some(self.root)
    }

    /// A node.
    pub fn branch(&self, node: usize) -> &Branch {
        &self.nodes[node]
    }

    /// The triangles of every leaf, children in order.
    pub fn leaves(&self) -> Vec<&[u32]> {
        let mut leaves = Vec::new();
        let mut stack: Vec<usize> = self.root().into_iter().collect();
        while let Some(node) = stack.pop() {
            match &self.nodes[node] {
                Branch::Leaf(triangles) => leaves.push(triangles.as_slice()),
                Branch::Inner(children) => stack.extend(children.iter().rev()),
            }
        }
        leaves
    }
}
