// What the page itself says, in both languages. Values go into the CSV; labels are for people.

export const WORDS = {
  begin: { fr: 'Commencer', en: 'Begin' },
  next: { fr: 'Suivant', en: 'Next' },
  play: { fr: '▶ Voir le signe', en: '▶ Watch the sign' },
  again: { fr: '↻ Revoir', en: '↻ Watch again' },
  playing: { fr: '… lecture', en: '… playing' },
  progress: { fr: (i, n) => `${i} sur ${n}`, en: (i, n) => `${i} of ${n}` },
  missing: { fr: 'Merci de répondre à toutes les questions.', en: 'Please answer all questions.' },
  unseen: { fr: 'Merci de regarder d’abord le signe.', en: 'Please watch the sign first.' },
  realism: { fr: 'Ce mouvement vous semble-t-il réaliste ?', en: 'Does this movement look realistic to you?' },
  thanks: { fr: 'Merci !', en: 'Thank you!' },
  explain: {
    fr: 'Vos réponses sont anonymes et ne sont que dans cette page. Téléchargez-les et envoyez le fichier à la personne qui vous a donné ce questionnaire.',
    en: 'Your answers are anonymous, and only in this page. Download them and send the file to whoever gave you this questionnaire.',
  },
  download: { fr: 'Télécharger mes réponses (CSV)', en: 'Download my answers (CSV)' },
  copy: { fr: 'Ou copiez-les d’ici :', en: 'Or copy them from here:' },
  noWebGL: {
    fr: 'Ce navigateur n’offre pas WebGL 2, dont l’avatar a besoin. Un autre navigateur devrait convenir.',
    en: 'This browser offers no WebGL 2, which the avatar needs. Another browser should help.',
  },
};

/** The ends and steps of the 5-point scale. */
export const SCALE = [
  { fr: 'pas du tout', en: 'not at all' }, { fr: 'plutôt pas', en: 'rather not' }, { fr: 'moyennement', en: 'somewhat' },
  { fr: 'plutôt oui', en: 'rather' }, { fr: 'tout à fait', en: 'very' },
];

/** The participant's sheet (Naert et al. 2021, §7.1.2). */
export const SHEET = [
  { name: 'age', label: { fr: 'Âge', en: 'Age' } },
  {
    name: 'gender', label: { fr: 'Vous êtes', en: 'You are' }, choices: [
      ['woman', { fr: 'une femme', en: 'a woman' }], ['man', { fr: 'un homme', en: 'a man' }],
      ['unstated', { fr: 'je ne souhaite pas répondre', en: 'I prefer not to say' }],
    ],
  },
  {
    name: 'hearing', label: { fr: 'Vous êtes', en: 'You are' }, choices: [
      ['born-deaf', { fr: 'sourd·e de naissance', en: 'deaf since birth' }], ['became-deaf', { fr: 'devenu·e sourd·e', en: 'deaf since later' }],
      ['hard-of-hearing', { fr: 'malentendant·e', en: 'hard of hearing' }], ['hearing', { fr: 'entendant·e', en: 'hearing' }],
    ],
  },
  {
    name: 'level', label: { fr: 'Votre niveau en langue des signes française', en: 'Your level of French Sign Language' }, choices: [
      ['none', { fr: 'aucune connaissance', en: 'no knowledge' }], ['beginner', { fr: 'débutant', en: 'beginner' }],
      ['quite-good', { fr: 'assez bon', en: 'quite good' }], ['good', { fr: 'bon', en: 'good' }],
      ['very-good', { fr: 'très bon', en: 'very good' }], ['native', { fr: 'langue maternelle', en: 'native' }],
      ['interpreter', { fr: 'interprète', en: 'interpreter' }],
    ],
  },
];
