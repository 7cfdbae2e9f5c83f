// Starts the viewer. The modules stand in the page as plain text, because a page opened from disk
// may not import files; each becomes a blob: URL, and an import map gives it back its file name.
(() => {
  const texts = document.querySelectorAll('script[data-module]');
  const imports = {};
  for (const element of texts) {
    // A blob has no folder, so './a.js' and '../utils/a.js' become the bare name 'a.js'.
    const source = element.textContent.replace(
      /(\bfrom\s*|\bimport\s*)(["'])\.{1,2}\/(?:[\w.-]+\/)*([\w.-]+\.js)\2/g, '$1$2$3$2');
    imports[element.dataset.module] = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
  }
  imports.three = imports['three.module.min.js'];
  const map = document.createElement('script');
  map.type = 'importmap';
  map.textContent = JSON.stringify({ imports });
  document.head.append(map);
  const fail = (error) => {
    const message = document.getElementById('message');
    message.textContent = `The viewer could not start.\n${error && error.message || error}`;
    message.hidden = false;
    window.chereme = { error: String(error) };
    window.DONE = 1;
  };
  import('main.js').then((main) => main.start()).catch(fail);
})();
